// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/readable_pixels.h"

#include <algorithm>
#include <vector>

#include "plugin/tool/file/read_native.h"
#include "plugin/tool/file/rows_together.h"

namespace ddt::tool {

namespace {

/// Of tiles one row at a time, which may be large.
int rows_to_try(const OIIO::ImageSpec& spec) {
    return spec.tile_width > 0 ? rows_together(spec) : rows_to_read(spec, 16);
}

} // namespace

bool can_be_read(OIIO::ImageInput& input, int begin, int end) {
    const OIIO::ImageSpec& spec = input.spec();
    const Rect all = readable(spec, {spec.x, begin, spec.x + spec.width, end});
    const int rows = rows_to_try(spec);
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
