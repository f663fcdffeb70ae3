// SPDX-License-Identifier: Apache-2.0
// Rows that a file keeps together.
#pragma once

#include <OpenImageIO/imageio.h>

namespace ddt::tool {

/// Scanlines that a file of this spec keeps together, as far as it says so (TIFF); 1 to 2^20.
int rows_in_strip(const OIIO::ImageSpec& spec);

} // namespace ddt::tool
