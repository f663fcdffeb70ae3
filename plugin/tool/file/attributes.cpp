// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/attributes.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include <linux/limits.h>
#include <sys/xattr.h>

namespace ddt::tool {

namespace {

constexpr const char* list_name = "system.posix_acl_access";

/// Whether the error says that there is no such attribute, or could be none.
bool is_absence(int number) {
    return number == ENODATA || number == ENOTSUP || number == ENOSYS;
}

/// By the path: to look at a list a file need not be readable; to look at notes it must. False with
/// errno.
bool read_attribute(const std::string& path, const char* name, std::string& value) {
    value.resize(XATTR_SIZE_MAX);
    const ssize_t n = getxattr(path.c_str(), name, value.data(), value.size());
    value.resize(size_t(std::max<ssize_t>(n, 0)));
    return n >= 0;
}

std::vector<std::string> names_of_notes(const std::string& path) {
    std::string names(XATTR_LIST_MAX, '\0');
    const ssize_t n = listxattr(path.c_str(), names.data(), names.size());
    std::vector<std::string> notes;
    for (ssize_t at = 0; at < n; at += ssize_t(std::strlen(&names[size_t(at)])) + 1)
        if (const std::string name = &names[size_t(at)]; name.compare(0, 5, "user.") == 0)
            notes.push_back(name);
    return notes;
}

/// A list with the rights of a mode for those that a mode knows. The format is the kernel's,
/// linux/posix_acl_xattr.h: a version in four bytes, then for each entry tag and rights in two
/// bytes each, the lower first, and an id in four.
std::string with_mode(std::string list, mode_t mode) {
    constexpr size_t head = 4, entry = 8;
    for (size_t at = head; at + entry <= list.size(); at += entry) {
        const int tag = uint8_t(list[at]) | uint8_t(list[at + 1]) << 8;
        const int shift = tag == 0x01 ? 6 : tag == 0x10 ? 3 : tag == 0x20 ? 0 : -1;
        if (shift >= 0) // owner, mask, others
            list[at + 2] = char(mode >> shift & 7);
    }
    return list;
}

} // namespace

Attributes::Attributes(const std::string& path) {
    if (!read_attribute(path, list_name, m_list))
        m_unknown = !is_absence(errno);
    for (const std::string& name : names_of_notes(path))
        if (std::string value; read_attribute(path, name.c_str(), value))
            m_notes.emplace_back(name, value);
}

bool Attributes::give_rights(int descriptor, mode_t mode) const {
    const std::string list = with_mode(m_list, mode);
    if (!list.empty() && fsetxattr(descriptor, list_name, list.data(), list.size(), 0) == 0)
        return true;
    // Some systems do not take away what is not there.
    const bool has_none = fremovexattr(descriptor, list_name) == 0 || is_absence(errno) ||
                          (fgetxattr(descriptor, list_name, nullptr, 0) < 0 && is_absence(errno));
    return has_none && m_list.empty() && !m_unknown;
}

void Attributes::give_notes(int descriptor) const {
    for (const auto& [name, value] : m_notes)
        fsetxattr(descriptor, name.c_str(), value.data(), value.size(), 0);
}

} // namespace ddt::tool
