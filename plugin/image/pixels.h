// SPDX-License-Identifier: Apache-2.0
// Regions of an ImageBuf as plain rows.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/rect.h"

namespace ddt {

/// The first byte of a channel of a pixel of a flat image, which may lie at any z.
inline const void* address(const OIIO::ImageBuf& image, int x, int y, int channel) {
    return image.pixeladdr(x, y, image.spec().z, channel);
}
inline void* address(OIIO::ImageBuf& image, int x, int y, int channel) {
    return image.pixeladdr(x, y, image.spec().z, channel);
}

/// Copy channels [chbegin, chend) of the pixels of `r`, which lie within the data window, to
/// `out`: interleaved values of `type`, rows without gaps; numbers convert as OpenImageIO does.
/// Thread-safe. False with one line in `error` when a file behind the image cannot be read.
bool read_pixels(const OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend,
                 OIIO::TypeDesc type, void* out, std::string& error);

/// The other way, into an image in local memory; values without gaps. 32-bit integers keep their
/// bits in both types of these. Thread-safe for different pixels.
void write_pixels(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, OIIO::TypeDesc type,
                  const void* values);

/// The same from floats of which `stride` make a pixel, the first of them being channel chbegin.
/// Integers get the nearest value, and 0 for NaN. May change `values`.
void write_floats(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, float* values,
                  int stride);

/// The type in which pixels are copied from src to dst: src's own, or floats where NaN, which has
/// no integer, may have to become one.
OIIO::TypeDesc copied_type(const OIIO::ImageBuf& src, const OIIO::ImageBuf& dst);
/// Write pixels that were read in that type; they may be changed.
void write_copied(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, OIIO::TypeDesc type,
                  void* values);

} // namespace ddt
