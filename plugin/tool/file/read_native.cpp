// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/read_native.h"

#include <algorithm>

#include "plugin/image/file_tiles.h"

namespace ddt::tool {

namespace {

/// [begin, end) cut to the file's pixels along an axis and extended to whole tiles.
void to_tiles(int first, int size, int tile, int& begin, int& end) {
    const int side = tile_side(tile, size);
    begin = std::max(begin - first, 0) / side * side;
    end = std::min(rounded_up(std::min(end - first, size), side), size);
    begin += first;
    end += first;
}

} // namespace

bool read_native(OIIO::ImageInput& input, const Rect& r, int chbegin, int chend, void* to) {
    const OIIO::ImageSpec& spec = input.spec();
    const int number = input.current_subimage();
    return spec.tile_width > 0 ? input.read_tiles(number, 0, r.x0, r.x1, r.y0, r.y1, spec.z,
                                                  spec.z + 1, chbegin, chend, OIIO::TypeUnknown, to)
                               : input.read_scanlines(number, 0, r.y0, r.y1, spec.z, chbegin, chend,
                                                      OIIO::TypeUnknown, to);
}

bool read_native(OIIO::ImageInput& input, const Rect& r, void* to) {
    return read_native(input, r, 0, input.spec().nchannels, to);
}

Rect readable(const OIIO::ImageSpec& file, const Rect& r) {
    const bool tiled = file.tile_width > 0;
    Rect all = r;
    to_tiles(file.x, file.width, tiled ? file.tile_width : file.width, all.x0, all.x1);
    to_tiles(file.y, file.height, tiled ? file.tile_height : 1, all.y0, all.y1);
    return all;
}

} // namespace ddt::tool
