// SPDX-License-Identifier: Apache-2.0
// A file that claims a tile far larger than its image.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "tests/temporary.h"

namespace ddt {

/// Write a TIFF of one column of 16 grey pixels of 8 bits, 0 to 15, in one tile, that wide, of so
/// many rows, of which the file has 256 bytes; libtiff reads no such tile, OpenImageIO tells of it.
inline std::string write_huge_tile(const std::string& name, uint32_t tile_rows) {
    const auto bytes_of = [](uint32_t number, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i)
            text += char(number >> (8 * i));
        return text;
    };
    struct Tag {
        uint32_t number, type, value; // of TIFF 6.0: 3 is a short, 4 a long
    };
    constexpr uint32_t tags = 10, data = 8 + 2 + tags * 12 + 4;
    const std::vector<Tag> directory = {
        {256, 4, 1}, {257, 4, 16}, {258, 3, 8},         {259, 3, 1},    {262, 3, 1},
        {277, 3, 1}, {322, 4, 1},  {323, 4, tile_rows}, {324, 4, data}, {325, 4, 256}};
    std::string file = std::string("II*\0", 4) + bytes_of(8, 4) + bytes_of(tags, 2);
    for (const Tag& tag : directory)
        file += bytes_of(tag.number, 2) + bytes_of(tag.type, 2) + bytes_of(1, 4) +
                bytes_of(tag.value, 4);
    file += bytes_of(0, 4);
    for (int i = 0; i < 256; ++i)
        file += char(i);
    const std::string path = temporary(name);
    std::ofstream(path, std::ios::binary) << file;
    return path;
}

} // namespace ddt
