// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/readable_pixels.h"

#include <algorithm>
#include <vector>

#include "plugin/image/file_tiles.h"
#include "plugin/tool/file/read_native.h"
#include "plugin/tool/file/rows_together.h"

namespace ddt::tool {

namespace {

/// Rows that are read at once: the readers of EXR and TIFF decompress them side by side.
int rows_to_read(const OIIO::ImageSpec& spec) {
    constexpr size_t bytes = size_t(8) << 20;
    const int wanted = std::max(16, int(bytes / std::max<size_t>(spec.scanline_bytes(true), 1)));
    return spec.tile_height > 0 ? tile_side(spec.tile_height, spec.height)
                                : rounded_up(wanted, rows_in_strip(spec));
}

} // namespace

bool can_be_read(OIIO::ImageInput& input, int begin, int end) {
    const OIIO::ImageSpec& spec = input.spec();
    const Rect all = readable(spec, {spec.x, begin, spec.x + spec.width, end});
    const int rows = rows_to_read(spec);
    // Room for whole tiles: OpenImageIO's reader writes beyond the image's edge (2.4.7, TIFF).
    const size_t width = size_t(spec.width) + size_t(std::max(spec.tile_width, 0));
    const size_t height = size_t(std::max(std::min(rows, spec.height), spec.tile_height));
    std::vector<char> pixels(spec.pixel_bytes(true) * width * height);
    for (int y = all.y0; y < all.y1; y += rows)
        if (!read_native(input, {all.x0, y, all.x1, std::min(all.y1, y + rows)}, pixels.data()))
            return false;
    return true;
}

bool can_be_read(OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    return can_be_read(input, spec.y, spec.y + spec.height);
}

bool may_pass_over(const std::string& format, const OIIO::ImageSpec& spec) {
    return format == "tiff" && spec.depth <= 1;
}

} // namespace ddt::tool
