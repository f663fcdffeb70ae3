// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/unfinished.h"

#include <atomic>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iterator>
#include <mutex>
#include <new>

#include <sys/stat.h>
#include <unistd.h>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

namespace {

enum State { unused, filling, listed };

/// No allocation and no lock: a signal handler reads it.
struct Slot {
    std::atomic<int> state{unused};
    char path[PATH_MAX];
    dev_t device; ///< of the file that had the name when it was listed
    ino_t inode;
};
Slot slots[64];

/// Whether the name still is the file's. POSIX has lstat() among what signal handlers may call.
bool is_kept(const Slot& slot) {
    struct stat there {};
    return lstat(slot.path, &there) == 0 && there.st_dev == slot.device &&
           there.st_ino == slot.inode;
}

void remove_listed() {
    for (const Slot& slot : slots)
        if (slot.state.load() == listed && is_kept(slot))
            unlink(slot.path);
}

/// Those that end a process unless it does something about them; of schedulers, SIGUSR1 and SIGUSR2
/// (Grid Engine's -notify, Slurm's --signal). Not those of a program gone wrong.
const int signals[] = {
    SIGINT,    SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGUSR1, SIGUSR2, SIGALRM, SIGPROF, SIGVTALRM,
#ifdef SIGIO
    SIGIO,
#endif
#ifdef SIGPWR
    SIGPWR,
#endif
#ifdef SIGSTKFLT
    SIGSTKFLT,
#endif
};

/// Call f(signal) for these and for those of real time, which a system numbers as it likes.
template <class F>
void for_each_signal(F f) {
    for (const int signal : signals)
        f(signal);
    for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal)
        f(signal);
}

/// Of EndsWithoutMemory.
std::mutex ends_lock;
int ends = 0;
std::new_handler before_ends = nullptr;

std::atomic<int> waited_for{0};
std::atomic<bool> ending{false};

void sleep_a_moment() {
    const timespec millisecond{0, 1000000};
    nanosleep(&millisecond, nullptr);
}

void remove_all() {
    ending = true;
    // Not for ever: a file system may hang.
    for (int i = 0; waited_for > 0 && i < 2000; ++i)
        sleep_a_moment();
    remove_listed();
}

/// Others wait meanwhile, or one that comes at once would end the program before the files are
/// gone.
void end(int number) {
    remove_all();
    // This one ends the program, and the parent sees by what.
    std::signal(number, SIG_DFL);
    sigset_t this_one;
    sigemptyset(&this_one);
    sigaddset(&this_one, number);
    raise(number);
    pthread_sigmask(SIG_UNBLOCK, &this_one, nullptr);
}

} // namespace

void remove_unfinished() {
    static std::atomic_flag begun = ATOMIC_FLAG_INIT;
    static thread_local bool here = false; // it may run out of memory meanwhile
    while (!here && begun.test_and_set())
        sleep_a_moment();
    here = true;
    remove_all();
}

void end_without_memory() {
    remove_unfinished();
    constexpr char line[] = "ddt: out of memory\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line, sizeof(line) - 1);
    std::_Exit(exit_resources);
}

void remove_unfinished_on_signals() {
    struct sigaction action {};
    action.sa_handler = end;
    sigemptyset(&action.sa_mask);
    for_each_signal([&](int signal) { sigaddset(&action.sa_mask, signal); });
    for_each_signal([&](int signal) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) // as under nohup
            sigaction(signal, &action, nullptr);
    });
    std::atexit(remove_listed);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

SignalsWait::SignalsWait() {
    // This thread would wait for itself; another's handler waits for the number to be 0.
    sigset_t these;
    sigemptyset(&these);
    for_each_signal([&](int signal) { sigaddset(&these, signal); });
    pthread_sigmask(SIG_BLOCK, &these, &m_before);
    ++waited_for;
    if (!ending)
        return;
    --waited_for;
    for (;;) // too late to make anything
        sleep_a_moment();
}

SignalsWait::~SignalsWait() {
    --waited_for;
    pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
}

// The first sets the handler, and the last to go has the one from before back.
EndsWithoutMemory::EndsWithoutMemory() {
    const std::lock_guard<std::mutex> lock(ends_lock);
    if (ends++ == 0)
        before_ends = std::set_new_handler(end_without_memory);
}

EndsWithoutMemory::~EndsWithoutMemory() {
    const std::lock_guard<std::mutex> lock(ends_lock);
    if (--ends == 0)
        std::set_new_handler(before_ends);
}

int list_unfinished(const std::string& path) {
    struct stat there {};
    if (path.size() >= PATH_MAX || lstat(path.c_str(), &there) != 0)
        return -1;
    for (int i = 0; i < int(std::size(slots)); ++i) {
        int expected = unused;
        if (!slots[i].state.compare_exchange_strong(expected, filling))
            continue;
        std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
        slots[i].device = there.st_dev;
        slots[i].inode = there.st_ino;
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
