// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/rows_together.h"

#include <algorithm>

#include "plugin/image/file_tiles.h"

namespace ddt::tool {

int rows_in_strip(const OIIO::ImageSpec& spec) {
    return std::clamp(spec.get_int_attribute("tiff:RowsPerStrip", 1), 1, 1 << 20);
}

int rows_together(const OIIO::ImageSpec& spec) {
    return spec.tile_width > 0 ? tile_side(spec.tile_height, spec.height) : rows_in_strip(spec);
}

int rows_to_read(const OIIO::ImageSpec& spec, int least) {
    constexpr size_t bytes = size_t(8) << 20;
    const int wanted = int(bytes / std::max<size_t>(spec.scanline_bytes(true), 1));
    return rounded_up(std::max(least, wanted), rows_together(spec));
}

} // namespace ddt::tool
