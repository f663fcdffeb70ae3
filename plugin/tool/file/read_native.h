// SPDX-License-Identifier: Apache-2.0
// Pixels as a file has them.
#pragma once

#include <OpenImageIO/imageio.h>

#include "ddt/rect.h"

namespace ddt::tool {

/// Read channels [chbegin, chend) of pixels of the image that the input is at as they are, without
/// gaps: whole tiles where it has them, else whole rows. False with a line in input.geterror().
bool read_native(OIIO::ImageInput& input, const Rect& r, int chbegin, int chend, void* to);
/// All channels.
bool read_native(OIIO::ImageInput& input, const Rect& r, void* to);

/// Before rows from this one on are read of which the one above was not just read: the reader of
/// TIFF begins at the top again where strips are compressed, unless it has read a whole one.
void go_to_row(OIIO::ImageInput& input, int row);

/// [r.x0, r.x1) x [r.y0, r.y1) cut to the file's pixels and extended to what read_native() reads.
Rect readable(const OIIO::ImageSpec& file, const Rect& r);

} // namespace ddt::tool
