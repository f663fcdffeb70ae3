// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/file_state.h"

#include "plugin/image/lazy_file.h"

namespace ddt::tool {

namespace {

bool same(const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

/// Whether something else than bytes tells why the file's last time is another: the number of its
/// names (backups make hard links, and a result that takes one of them leaves one less) or who may
/// do what with it.
bool has_other_links_or_rights(const struct stat& a, const struct stat& b) {
    return a.st_nlink != b.st_nlink || a.st_mode != b.st_mode || a.st_uid != b.st_uid ||
           a.st_gid != b.st_gid;
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
           a.st_size == b.st_size && same(a.st_mtim, b.st_mtim) &&
           (same(a.st_ctim, b.st_ctim) || has_other_links_or_rights(a, b));
}

bool FileState::is_of_one_file(bool was_read) const {
    return is_unchanged() || (was_read && is_file() && !FileState(m_path).m_there);
}

bool FileState::confirm(bool made, Failure& failure) const {
    const bool may_be_the_reason = made || failure.code == exit_failed;
    if (!may_be_the_reason || is_of_one_file(made))
        return made;
    failure = {why_changed(m_path), exit_resources};
    return false;
}

} // namespace ddt::tool
