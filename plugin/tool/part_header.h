// SPDX-License-Identifier: Apache-2.0
// What a part's file tells the join.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "ddt/core.h"
#include "plugin/tool/part.h"

namespace ddt::tool {

/// The type in which a part keeps numbers of `type` so that they come back; unknown if there is
/// none.
OIIO::TypeDesc stored_type(OIIO::TypeDesc type);

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

/// Of a part of a whole that has this spec. job: fingerprint().
PartHeader header_of(const std::string& job, const Part& part, const OIIO::ImageSpec& whole);

} // namespace ddt::tool
