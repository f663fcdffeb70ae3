// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/read_native.h"

#include <algorithm>
#include <string>
#include <vector>

#include "plugin/image/file_tiles.h"
#include "plugin/tool/file/rows_together.h"

namespace ddt::tool {

namespace {

bool is_tiff(const OIIO::ImageInput& input) {
    return input.format_name() == std::string("tiff");
}

/// Whether each channel has strips of its own: libtiff reads them whole or, where there is
/// compression, not at all.
bool is_separate(const OIIO::ImageSpec& spec) {
    return spec.get_string_attribute("planarconfig") == "separate";
}

/// Of strips that it reads several of at once, OpenImageIO's reader of TIFF (2.4 to 3.1) inflates
/// those of 8 and 16 bits by threads of its own, says nothing of one that it cannot, and reads
/// beyond its memory where one cannot be read. Row by row libtiff does it, which takes one thread
/// as long as several strips take two.
bool forgets_errors(const OIIO::ImageSpec& spec) {
    return spec.get_string_attribute("compression") == "zip" && spec.format.size() <= 2 &&
           !is_separate(spec);
}

bool read_rows(OIIO::ImageInput& input, int begin, int end, int chbegin, int chend, char* to) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto read = [&](int from, int until, char* at) {
        return input.read_scanlines(input.current_subimage(), 0, from, until, spec.z, chbegin,
                                    chend, OIIO::TypeUnknown, at);
    };
    if (!is_tiff(input))
        return read(begin, end, to);
    if (!forgets_errors(spec)) {
        input.geterror(); // of before
        // It notes the error of a strip, and goes on.
        return read(begin, end, to) && !input.has_error();
    }
    const size_t row = size_t(spec.width) * spec.pixel_bytes(chbegin, chend, true);
    for (int y = begin; y < end; ++y, to += row)
        if (!read(y, y + 1, to))
            return false;
    return true;
}

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
    return spec.tile_width > 0
               ? input.read_tiles(number, 0, r.x0, r.x1, r.y0, r.y1, spec.z, spec.z + 1, chbegin,
                                  chend, OIIO::TypeUnknown, to)
               : read_rows(input, r.y0, r.y1, chbegin, chend, static_cast<char*>(to));
}

bool read_native(OIIO::ImageInput& input, const Rect& r, void* to) {
    return read_native(input, r, 0, input.spec().nchannels, to);
}

void go_to_row(OIIO::ImageInput& input, int row) {
    const OIIO::ImageSpec& spec = input.spec();
    const int rows = rows_in_strip(spec);
    const int end = spec.y + (row - spec.y) / rows * rows;
    if (spec.tile_width > 0 || !is_tiff(input) || rows < 2 || end - rows < spec.y)
        return;
    std::vector<char> unused(spec.scanline_bytes(true) * size_t(rows));
    (void)input.read_native_scanlines(input.current_subimage(), 0, end - rows, end, spec.z,
                                      unused.data());
    input.geterror();
}

Rect readable(const OIIO::ImageSpec& file, const Rect& r) {
    const bool tiled = file.tile_width > 0;
    Rect all = r;
    to_tiles(file.x, file.width, tiled ? file.tile_width : file.width, all.x0, all.x1);
    const int strip = is_separate(file) ? rows_in_strip(file) : 1;
    to_tiles(file.y, file.height, tiled ? file.tile_height : strip, all.y0, all.y1);
    return all;
}

} // namespace ddt::tool
