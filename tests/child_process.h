// SPDX-License-Identifier: Apache-2.0
// Work in a child process, which may end it or take memory that is counted by itself.
#pragma once

#include <cstdint>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ddt::test {

/// How a child process ended.
struct Ended {
    int code = -1;             ///< its exit status; -1: a signal ended it, or it was never begun
    int signal = 0;            ///< that ended it
    int64_t peak_resident = 0; ///< bytes
};

/// Fork and wait for the child, which ends with what `work` returns. After so many seconds SIGALRM
/// ends it.
template <class Work>
Ended in_child(Work&& work, unsigned seconds = 60) {
    const pid_t child = fork();
    if (child == 0) {
        alarm(seconds);
        _exit(work());
    }
    Ended ended;
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child)
        return ended;
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    ended.peak_resident = int64_t(usage.ru_maxrss) * 1024;
    return ended;
}

} // namespace ddt::test
