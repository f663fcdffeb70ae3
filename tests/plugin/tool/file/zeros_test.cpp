// SPDX-License-Identifier: Apache-2.0
// File systems that make holes of zeros, and one that is full: as they answer.
#include "plugin/tool/file/image_file.h"

#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>
#include <linux/magic.h>

#include "tests/temporary.h"

namespace {
long system_of_files;
bool is_full;
} // namespace

extern "C" {
int __real_fstatfs(int file, struct statfs* system);
off_t __real_lseek(int file, off_t offset, int whence);
ssize_t __real_pwrite(int file, const void* bytes, size_t n, off_t offset);

int __wrap_fstatfs(int file, struct statfs* system);
int __wrap_fstatfs(int file, struct statfs* system) {
    const int result = __real_fstatfs(file, system);
    system->f_type = decltype(system->f_type)(system_of_files);
    return result;
}

off_t __wrap_lseek(int file, off_t offset, int whence);
off_t __wrap_lseek(int file, off_t offset, int whence) {
    return whence == SEEK_HOLE ? offset : __real_lseek(file, offset, whence);
}

ssize_t __wrap_pwrite(int file, const void* bytes, size_t n, off_t offset);
ssize_t __wrap_pwrite(int file, const void* bytes, size_t n, off_t offset) {
    errno = ENOSPC;
    return is_full ? -1 : __real_pwrite(file, bytes, n, offset);
}
}

namespace ddt::tool {
namespace {

/// Write a black picture by a writer that says nothing of a full disk.
bool write_black(const std::string& path) {
    ImageFile file;
    Failure failure;
    const OIIO::ImageSpec spec(64, 64, 3, OIIO::TypeUInt8);
    const std::vector<uint8_t> black(64 * 64 * 3);
    const bool written = file.create(path, failure) && file.open(spec, failure) &&
                         file.write_rows(0, 64, OIIO::TypeUInt8, black.data()) &&
                         file.commit(failure);
    EXPECT_EQ(written, failure.why.empty()) << failure.why;
    EXPECT_EQ(std::filesystem::exists(path), written);
    return written;
}

TEST(Zeros, MayBecomeHolesUnlessTheDiskIsFull) {
    const std::string path = temporary("black.fits");
    const std::string by_itself = temporary("by_itself.fits");
    OIIO::ImageBuf black(OIIO::ImageSpec(64, 64, 3, OIIO::TypeUInt8));
    ASSERT_TRUE(black.write(by_itself));
    constexpr long zfs = 0x2fc12fc1;
    for (const long system : {zfs, long(NFS_SUPER_MAGIC), long(OVERLAYFS_SUPER_MAGIC)}) {
        system_of_files = system;
        is_full = false;
        EXPECT_TRUE(write_black(path)) << std::hex << system;
        EXPECT_EQ(OIIO::ImageInput::open(path)->spec().width, 64);
        const auto bytes = std::filesystem::file_size(path);
        is_full = true;
        std::filesystem::remove(path);
        EXPECT_FALSE(write_black(path)) << std::hex << system;
        // The disk is asked by a write, of which nothing stays.
        is_full = false;
        system_of_files = long(EXT4_SUPER_MAGIC);
        EXPECT_EQ(bytes, std::filesystem::file_size(by_itself));
    }
}

TEST(Zeros, AreNoHolesWhereTheSystemKeepsThem) {
    is_full = false;
    for (const long system : {long(EXT4_SUPER_MAGIC), long(XFS_SUPER_MAGIC), long(TMPFS_MAGIC),
                              long(BTRFS_SUPER_MAGIC), long(F2FS_SUPER_MAGIC)}) {
        system_of_files = system;
        EXPECT_FALSE(write_black(temporary("left out.fits"))) << std::hex << system;
    }
}

} // namespace
} // namespace ddt::tool
