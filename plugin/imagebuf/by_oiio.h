// SPDX-License-Identifier: Apache-2.0
// What is left to OpenImageIO's own filters.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// Whether all was read of an image in OpenImageIO's cache since it had no error.
bool check_was_read(const OIIO::ImageBuf& reader, std::string& error);

/// Call work(image) of src, which leaves to OpenImageIO to read its pixels. That goes on with black
/// where a file cannot be read: then false with one line in `error`.
template <class Work>
bool while_reading(const OIIO::ImageBuf& src, std::string& error, Work&& work) {
    if (src.storage() != OIIO::ImageBuf::IMAGECACHE)
        return work(src);
    // Of the same pixels, with errors of its own: another may be pending on src.
    const OIIO::ImageBuf reader(src);
    reader.geterror();
    const bool done = work(reader);
    return check_was_read(reader, error) && done;
}

/// Whether OpenImageIO's own filters write this type; of another they make dst an image of floats,
/// in memory of its own.
bool is_written_by_oiio(OIIO::TypeDesc type);

/// OpenImageIO's default filter for the pixels and channels of `roi` (its own resize writes all
/// channels).
bool resize_by_oiio(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                    int nthreads, std::string& error);

} // namespace ddt
