// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/compression.h"

#include "core/base/parse_number.h"

namespace ddt::tool {

namespace {

struct Compression {
    const char *format, *name;
    int highest; ///< the level's, from 1 on; 0: it has none
};
constexpr int highest_dwa = 100000; // OpenEXR has no bound
constexpr Compression compressions[] = {
    {"openexr", "none", 0},
    {"openexr", "rle", 0},
    {"openexr", "zip", 9},
    {"openexr", "zips", 9},
    {"openexr", "piz", 0},
    {"openexr", "pxr24", 0},
    {"openexr", "b44", 0},
    {"openexr", "b44a", 0},
    {"openexr", "dwaa", highest_dwa},
    {"openexr", "dwab", highest_dwa},
    {"tiff", "none", 0},
    {"tiff", "lzw", 0},
    {"tiff", "zip", 9},
    {"tiff", "packbits", 0},
    {"tiff", "jpeg", 100},
    {"jpeg", "jpeg", 100},
    {"png", "filtered", 0},
    {"png", "huffman", 0},
    {"png", "rle", 0},
    {"png", "fixed", 0},
    {"webp", "webp", 100},
    {"webp", "lossless", 0},
    {"heif", "heic", 100},
    {"heif", "avif", 100},
    {"targa", "none", 0},
    {"targa", "rle", 0},
    {"iff", "none", 0},
    {"iff", "rle", 0},
};

/// "dwaa[:1-100000]", or the name alone.
std::string with_levels(const Compression& c) {
    return c.name + (c.highest > 0 ? "[:1-" + std::to_string(c.highest) + "]" : "");
}

bool is_level(const std::string& text, int highest) {
    int level = 0;
    return parse_number(text, 1, highest, level);
}

} // namespace

bool check_compression(const std::string& given, const std::string& format, std::string& error) {
    const size_t colon = given.find(':');
    const std::string name = given.substr(0, colon);
    std::string allowed;
    for (const Compression& c : compressions) {
        if (!format.empty() && format != c.format)
            continue;
        if (name == c.name &&
            (colon == std::string::npos || is_level(given.substr(colon + 1), c.highest)))
            return true;
        if (const std::string word = with_levels(c);
            (", " + allowed + ",").find(", " + word + ",") == std::string::npos)
            allowed += (allowed.empty() ? "" : ", ") + word;
    }
    error = allowed.empty()
                ? "no compression can be chosen for files of the format " + format
                : "compression \"" + given + "\" is not allowed" +
                      (format.empty() ? "" : " in " + format) + "; allowed are " + allowed;
    return false;
}

} // namespace ddt::tool
