// Regions of an ImageBuf as plain rows.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"

namespace ddt {

/// Copy channels [chbegin, chend) of the pixels of `r`, which lie within the data window, to
/// `out`: interleaved values of `type`, rows without gaps; numbers convert as OpenImageIO does.
/// Thread-safe. False with one line in `error` when a file behind the image cannot be read.
bool read_pixels(const OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend,
                 OIIO::TypeDesc type, void* out, std::string& error);

/// The other way, into an image in local memory; `pixel_size` is the distance between pixels in
/// `values` in bytes, 0 for none but their own size. Thread-safe for different pixels.
void write_pixels(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, OIIO::TypeDesc type,
                  const void* values, OIIO::stride_t pixel_size = 0);

} // namespace ddt
