// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/exr_buffers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "plugin/image/file_tiles.h"

namespace ddt::tool {

namespace {

/// Rows that are compressed together.
int rows_in_block(const OIIO::ImageSpec& spec) {
    constexpr std::pair<const char*, int> known[] = {
        {"none", 1}, {"rle", 1},  {"zips", 1},  {"zip", 16},  {"pxr24", 16},
        {"piz", 32}, {"b44", 32}, {"b44a", 32}, {"dwaa", 32}, {"dwab", 256},
    };
    const std::string given = spec.get_string_attribute("compression", "zip");
    const std::string compression = given.substr(0, given.find(':'));
    for (const auto& [name, rows] : known)
        if (compression == name)
            return rows;
    return 16; // what OpenImageIO writes instead: zip
}

/// EXR has numbers of 16 and 32 bits.
int64_t bytes_of(OIIO::TypeDesc type) {
    return std::clamp<int64_t>(int64_t(type.size()), 2, 4);
}

int64_t pixel_bytes(const OIIO::ImageSpec& spec) {
    if (spec.channelformats.empty())
        return spec.nchannels * bytes_of(spec.format);
    int64_t bytes = 0;
    for (const OIIO::TypeDesc& type : spec.channelformats)
        bytes += bytes_of(type);
    return bytes;
}

int64_t parts_of(int64_t whole, int64_t part) {
    return (whole + part - 1) / part;
}

} // namespace

int64_t exr_buffers(const OIIO::ImageSpec& spec, int threads) {
    const bool tiled = spec.tile_width > 0 && spec.tile_height > 0;
    const int64_t width = tiled ? tile_side(spec.tile_width, spec.width) : spec.width;
    const int64_t height = tiled ? tile_side(spec.tile_height, spec.height)
                                 : std::min(rows_in_block(spec), spec.height);
    if (width < 1 || height < 1)
        return 0;
    const int64_t blocks = parts_of(spec.width, width) * parts_of(spec.height, height);
    // One thread has no pool (command/threads.h). A buffer is one of pixels, one that they are
    // sorted in and one that is compressed: 2.5 to 2.8 times the pixels were measured.
    const int64_t buffers = std::min<int64_t>(threads > 1 ? int64_t(2) * threads : 1, blocks);
    return buffers * 3 * width * height * pixel_bytes(spec);
}

} // namespace ddt::tool
