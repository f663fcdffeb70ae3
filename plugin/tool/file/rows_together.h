// SPDX-License-Identifier: Apache-2.0
// Rows that a file keeps together.
#pragma once

#include <OpenImageIO/imageio.h>

namespace ddt::tool {

/// Scanlines that a file of this spec keeps together, as far as it says so (TIFF); 1 to 2^20.
int rows_in_strip(const OIIO::ImageSpec& spec);

/// The same, or those of its tiles as far as the image goes.
int rows_together(const OIIO::ImageSpec& spec);

/// Rows to read at once, which the readers of EXR and TIFF decompress side by side: whole ones of
/// rows_together(), as many as make 8 MiB, and `least` or more.
int rows_to_read(const OIIO::ImageSpec& spec, int least);

} // namespace ddt::tool
