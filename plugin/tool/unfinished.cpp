// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/unfinished.h"

#include <atomic>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include <unistd.h>

namespace ddt::tool {

namespace {

enum State { unused, filling, listed };

/// No allocation and no lock: a signal handler reads it.
struct Slot {
    std::atomic<int> state{unused};
    char path[PATH_MAX];
};
Slot slots[64];

void remove_listed() {
    for (const Slot& slot : slots)
        if (slot.state.load() == listed)
            unlink(slot.path);
}

void end(int signal) {
    remove_listed();
    // The handler was for once: this one ends the program, and the parent sees by what.
    raise(signal);
}

} // namespace

void remove_unfinished_on_signals() {
    struct sigaction action {};
    action.sa_handler = end;
    action.sa_flags = SA_RESETHAND | SA_NODEFER;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) // as under nohup
            sigaction(signal, &action, nullptr);
    }
    std::atexit(remove_listed);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

int list_unfinished(const std::string& path) {
    if (path.size() >= PATH_MAX)
        return -1;
    for (int i = 0; i < int(std::size(slots)); ++i) {
        int expected = unused;
        if (!slots[i].state.compare_exchange_strong(expected, filling))
            continue;
        std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
        slots[i].state = listed;
        return i;
    }
    return -1;
}

void unlist_unfinished(int number) {
    if (number >= 0)
        slots[number].state = unused;
}

} // namespace ddt::tool
