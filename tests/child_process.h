// SPDX-License-Identifier: Apache-2.0
// Work in a child process, which may end it or take memory that is counted by itself.
#pragma once

#include <cstdint>
#include <grp.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

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

/// In a child of root's, who cannot come back: be this user, in this group and `others`.
inline bool become(uid_t user, gid_t group, const std::vector<gid_t>& others = {}) {
    return setgroups(others.size(), others.data()) == 0 && setgid(group) == 0 && setuid(user) == 0;
}

} // namespace ddt::test
