// SPDX-License-Identifier: Apache-2.0
// Whether a file was written to meanwhile.
#pragma once

#include <string>

#include <sys/stat.h>

namespace ddt::tool {

/// What changes with a file's bytes: which file has the name, its size and the times of its last
/// changes. A file that is not there never counts as unchanged.
class FileState {
public:
    explicit FileState(const std::string& path)
        : m_path(path), m_there(stat(path.c_str(), &m_state) == 0) {}

    bool is_unchanged() const {
        const FileState now(m_path);
        const struct stat &a = m_state, &b = now.m_state;
        return m_there && now.m_there && a.st_dev == b.st_dev && a.st_ino == b.st_ino &&
               a.st_size == b.st_size && same(a.st_mtim, b.st_mtim) && same(a.st_ctim, b.st_ctim);
    }

private:
    static bool same(const timespec& a, const timespec& b) {
        return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
    }

    std::string m_path;
    struct stat m_state {};
    bool m_there;
};

} // namespace ddt::tool
