// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/attributes.h"

#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>

#include "plugin/tool/file/whole_file.h"
#include "tests/child_process.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* access_list = "system.posix_acl_access";
constexpr const char* handed_down = "system.posix_acl_default";
constexpr uid_t named = 1234;

struct Entry {
    unsigned tag, rights;
    uint32_t id = uint32_t(-1);
};

/// As the kernel has it.
std::string bytes_of(const std::vector<Entry>& entries) {
    std::string bytes{2, 0, 0, 0};
    for (const Entry& e : entries) {
        for (const unsigned n : {e.tag, e.rights})
            bytes += {char(n & 255), char(n >> 8)};
        for (int shift = 0; shift < 32; shift += 8)
            bytes += char(e.id >> shift & 255);
    }
    return bytes;
}

/// user::rw-, user:1234:rw-, group::---, mask::rw-, other::---
std::string one_user_more() {
    return bytes_of({{0x01, 6}, {0x02, 6, named}, {0x04, 0}, {0x10, 6}, {0x20, 0}});
}

std::string attribute(const std::string& path, const char* name) {
    char value[256];
    const ssize_t n = getxattr(path.c_str(), name, value, sizeof value);
    return n < 0 ? "" : std::string(value, size_t(n));
}

bool set(const std::string& path, const char* name, const std::string& value) {
    return setxattr(path.c_str(), name, value.data(), value.size(), 0) == 0;
}

mode_t mode_of(const std::string& path) {
    struct stat there {};
    return stat(path.c_str(), &there) == 0 ? there.st_mode & 07777 : 0;
}

bool can_read(const std::string& path, uid_t user, gid_t group) {
    const auto read = [&] {
        return test::become(user, group) && access(path.c_str(), R_OK) == 0 ? 0 : 1;
    };
    return test::in_child(read).code == 0;
}

/// In a folder of each test's own, with a file "old" of mode 0660.
class AttributesTest : public testing::Test {
protected:
    AttributesTest() {
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
        std::ofstream(m_old) << "before";
        chmod(m_old.c_str(), 0660);
    }
    void replace() const {
        WholeFile file;
        Failure failure;
        ASSERT_TRUE(file.open(m_old, failure)) << failure.why;
        std::fputs("after", file.file());
        ASSERT_TRUE(file.commit(failure)) << failure.why;
        EXPECT_EQ(text_in(m_old), "after");
    }
    static std::string why_none(const char* of) {
        return std::string("no ") + of + " in " + temporary("") + ": " + std::strerror(errno);
    }

    const std::string m_folder = temporary("attributes"), m_old = m_folder + "/old";
};

TEST_F(AttributesTest, AnAccessControlListIsKept) {
    if (!set(m_old, access_list, one_user_more()))
        GTEST_SKIP() << why_none("access control lists");
    ASSERT_EQ(mode_of(m_old), 0660u);
    replace();
    EXPECT_EQ(attribute(m_old, access_list), one_user_more());
    EXPECT_EQ(mode_of(m_old), 0660u);
    if (geteuid() != 0)
        return; // only root can be somebody else
    fs::permissions(m_folder, fs::perms::all);
    fs::permissions(temporary(""), fs::perms(0711));
    EXPECT_TRUE(can_read(m_old, named, 4321));
    EXPECT_FALSE(can_read(m_old, 4321, getegid()));
}

TEST_F(AttributesTest, OfAFileThatHasGoneTheListIsKept) {
    if (!set(m_old, access_list, one_user_more()))
        GTEST_SKIP() << why_none("access control lists");
    WholeFile file;
    Failure failure;
    ASSERT_TRUE(file.open(m_old, failure)) << failure.why;
    fs::remove(m_old);
    ASSERT_TRUE(file.commit(failure)) << failure.why;
    EXPECT_EQ(attribute(m_old, access_list), one_user_more());
}

TEST_F(AttributesTest, WhatAFolderHandsDownIsNotAddedToAFileThatWasThere) {
    if (!set(m_folder, handed_down, one_user_more()))
        GTEST_SKIP() << why_none("access control lists");
    replace();
    EXPECT_EQ(attribute(m_old, access_list), "");
    EXPECT_EQ(mode_of(m_old), 0660u);
    // A new one gets it, as any file does.
    fs::remove(m_old);
    replace();
    EXPECT_EQ(attribute(m_old, access_list), one_user_more());
}

TEST_F(AttributesTest, ALimitedModeLimitsTheList) {
    if (!set(m_old, access_list, one_user_more()))
        GTEST_SKIP() << why_none("access control lists");
    const Attributes attributes(m_old);
    const std::string other = m_folder + "/other";
    const int descriptor = open(other.c_str(), O_RDWR | O_CREAT, 0600);
    ASSERT_GE(descriptor, 0);
    EXPECT_TRUE(attributes.give_rights(descriptor, 04604));
    EXPECT_EQ(attribute(other, access_list),
              bytes_of({{0x01, 6}, {0x02, 6, named}, {0x04, 0}, {0x10, 0}, {0x20, 4}}));
    close(descriptor);
}

TEST_F(AttributesTest, WhereTheListCannotBeGivenTheRightsAreNotEither) {
    if (!set(m_old, access_list, one_user_more()))
        GTEST_SKIP() << why_none("access control lists");
    const Attributes attributes(m_old);
    int ends[2] = {};
    ASSERT_EQ(pipe(ends), 0); // which has no attributes
    EXPECT_FALSE(attributes.give_rights(ends[0], 0660));
    EXPECT_TRUE(Attributes().give_rights(ends[0], 0660));
    // Of a file that could not be looked at nobody knows.
    EXPECT_FALSE(Attributes(m_folder + "/none").give_rights(ends[0], 0660));
    close(ends[0]);
    close(ends[1]);
}

TEST_F(AttributesTest, WhatUsersNotedIsKept) {
    if (!set(m_old, "user.note", "a shot") || !set(m_old, "user.empty", ""))
        GTEST_SKIP() << why_none("user.* attributes");
    replace();
    EXPECT_EQ(attribute(m_old, "user.note"), "a shot");
    EXPECT_EQ(getxattr(m_old.c_str(), "user.empty", nullptr, 0), 0);
}

} // namespace
} // namespace ddt::tool
