// SPDX-License-Identifier: Apache-2.0
// What libtiff says of a file that is written: OpenImageIO's writer passes over some of it.
#pragma once

#include <string>

#include <sys/types.h>

namespace ddt::tool {

/// From when it is made it listens to what libtiff says of writes that fail in the file which a
/// descriptor has open, by whichever descriptor they are made: a disk that is full for a moment
/// leaves pixels out and tables where they are not looked for. Hears nothing where OpenImageIO has
/// a libtiff of its own within it, or keeps to itself what libtiff says (2.5 and later, with
/// libtiff 4.5). Thread-safe.
class TiffWriteErrors {
public:
    explicit TiffWriteErrors(int descriptor);
    ~TiffWriteErrors();
    TiffWriteErrors(const TiffWriteErrors&) = delete;
    TiffWriteErrors& operator=(const TiffWriteErrors&) = delete;

    /// The first, or nothing.
    std::string first() const;

    /// For libtiff.
    bool is_of(dev_t device, ino_t inode) const { return device == m_device && inode == m_inode; }
    void hear(const char* said);

private:
    dev_t m_device = 0;
    ino_t m_inode = 0;
    char m_first[256] = ""; ///< there may be no memory when it is heard
};

} // namespace ddt::tool
