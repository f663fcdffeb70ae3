// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/file_state.h"

#include "plugin/image/lazy_file.h"

namespace ddt::tool {

namespace {

bool same(const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

} // namespace

FileState::FileState(const std::string& path)
    : m_path(path), m_there(stat(path.c_str(), &m_state) == 0) {}

bool FileState::is_unchanged() const {
    const FileState now(m_path);
    if (!is_file() && !now.is_file())
        return true;
    const struct stat &a = m_state, &b = now.m_state;
    return is_file() && now.is_file() && a.st_dev == b.st_dev && a.st_ino == b.st_ino &&
           a.st_size == b.st_size && same(a.st_mtim, b.st_mtim) && same(a.st_ctim, b.st_ctim);
}

bool FileState::confirm(bool made, Failure& failure) const {
    const bool may_be_the_reason = made || failure.code == exit_failed;
    if (!may_be_the_reason || is_unchanged())
        return made;
    failure = {why_changed(m_path), exit_resources};
    return false;
}

} // namespace ddt::tool
