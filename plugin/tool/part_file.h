// SPDX-License-Identifier: Apache-2.0
// Parts as files.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "plugin/tool/part.h"
#include "plugin/tool/resize_file.h"

namespace ddt::tool {

/// What a part's file says about itself. The pixels are in tiles; the data window is the part's,
/// the display window the whole's.
struct PartHeader {
    std::string job; ///< fingerprint()
    Part part;
    Rect whole;       ///< the data window of the whole
    std::string type; ///< the whole's pixel type, where the file's holds more
    /// The source's, empty if it says none: OpenEXR's files are all read as linear.
    std::string colour_space;
    std::string compression; ///< the source's, empty if it says none; parts are without loss
    /// The channels' names in the whole's order: a file's are sorted. Empty: as the file has them.
    std::vector<std::string> channels;
    std::string date;                   ///< the source's DateTime, empty if it says none
    std::vector<unsigned char> profile; ///< the source's ICC profile, or nothing
    int bits = 0;                       ///< oiio:BitsPerSample of the whole; 0: none
    bool no_aspect = false;             ///< the whole says no PixelAspectRatio

    void write_to(OIIO::ImageSpec& spec) const;
    /// Take it off a file's spec. False if that is of no part.
    bool take_from(OIIO::ImageSpec& spec);
};

/// Resize the share of the file `in` that makes a part, and write that to `out`, tile row by tile
/// row of the source: memory for one of them, and 256 MiB. Of a source in tiles, or in rows that
/// can be had singly, no more is read than the part needs. Both axes must grow or stay.
bool resize_part(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 Part part, const std::function<bool(float)>& progress, Failure& failure);

} // namespace ddt::tool
