// SPDX-License-Identifier: Apache-2.0
// Copies of pixels, as they are.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// What shows where the source has no pixels.
enum class Beyond { edge, black };

/// Write the pixels of `roi` from the source moved by (dx, dy): the same bits where the pixel types
/// are the same.
bool copy_moved(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi, int dx,
                int dy, Beyond beyond, std::string& error);

/// Make `copy` an image of its own with src's pixels and metadata, in this type. False with one
/// line in `error`.
bool copy_whole(OIIO::ImageBuf& copy, const OIIO::ImageBuf& src, OIIO::TypeDesc type,
                std::string& error);

} // namespace ddt
