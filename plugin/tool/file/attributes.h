// SPDX-License-Identifier: Apache-2.0
// What a file has beside bytes, owner and mode: its access control list, and what users noted.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace ddt::tool {

/// The extended attributes of a file that go over to the one that takes its place.
class Attributes {
public:
    Attributes() = default;
    explicit Attributes(const std::string& path);

    /// Give an open file the same access control list, or none if there was none: a new file has
    /// what its folder hands down. Owner, mask and others get the rights of `mode`, as chmod does
    /// it. False if that could not be done; then the group's bits of `mode`, which with a list are
    /// those of its mask, are nobody's to have, nor are the others', for the list may have kept
    /// some of them out.
    bool give_rights(int descriptor, mode_t mode) const;

    /// Give an open file the `user.*` attributes, as far as they could be read and it can have
    /// them.
    void give_notes(int descriptor) const;

private:
    std::string m_list;     ///< the access control list; empty: none
    bool m_unknown = false; ///< it could not be read
    std::vector<std::pair<std::string, std::string>> m_notes;
};

} // namespace ddt::tool
