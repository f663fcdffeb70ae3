// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/id_file.h"

#include <algorithm>

#include <OpenImageIO/imageio.h>

#include "plugin/image/windows.h"
#include "plugin/tool/picture.h"

namespace ddt::tool {

namespace {

/// [begin, end) cut to the file's pixels along an axis and extended to whole tiles.
void to_tiles(int first, int size, int tile, int& begin, int& end) {
    begin = std::max(begin - first, 0) / tile * tile;
    end = std::min((std::min(end - first, size) + tile - 1) / tile * tile, size);
    begin += first;
    end += first;
}

} // namespace

bool read_ids_of(const std::string& path, const OIIO::ImageBuf& image, const Rect& wanted,
                 OIIO::ImageBuf& ids, std::string& error) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) {
        error = why_unreadable(OIIO::geterror(), path);
        return false;
    }
    const OIIO::ImageSpec& file = input->spec();
    const bool tiled = file.tile_width > 0;
    Rect r = wanted;
    to_tiles(file.x, file.width, tiled ? file.tile_width : file.width, r.x0, r.x1);
    to_tiles(file.y, file.height, tiled ? file.tile_height : 1, r.y0, r.y1);
    OIIO::ImageSpec spec = image.spec();
    spec.set_format(image.nativespec().format);
    spec.x = r.x0;
    spec.y = r.y0;
    spec.width = r.width();
    spec.height = r.height();
    if (!take_memory(ids, spec, error))
        return false;
    if (read_native(*input, r, ids.localpixels()))
        return true;
    error = why_unreadable(input->geterror(), path);
    return false;
}

} // namespace ddt::tool
