// SPDX-License-Identifier: Apache-2.0
// Files behind OpenImageIO's caches that cannot be read.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// One call's reads of the file behind an image. A cache keeps as black what it could not read, and
/// reports that once, to one of those who ask: all others, meanwhile and later, get black and no
/// error. So calls that read the same file at once all fail if one of them does, and the last of
/// them makes the cache forget the file, so that the next call finds out for itself. For an image
/// in memory there is nothing to do. Thread-safe.
class CachedReads {
public:
    /// `image` must outlive this.
    explicit CachedReads(const OIIO::ImageBuf& image);
    ~CachedReads();
    CachedReads(const CachedReads&) = delete;
    CachedReads& operator=(const CachedReads&) = delete;

    /// Whether no read of any of these calls has failed; else one line in `error`. To be asked
    /// before the first read, too: a file is not read while it is being forgotten.
    bool all_well(std::string& error) const;

    /// Say that a read of an image failed, with one line.
    static void fail(const OIIO::ImageBuf& image, const std::string& error);

private:
    struct State;
    class Registry;

    const OIIO::ImageBuf& m_image;
    State* m_state = nullptr; ///< of the image's file; null: it is in memory
};

} // namespace ddt
