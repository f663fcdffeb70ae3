// SPDX-License-Identifier: Apache-2.0
// What a part's file tells the join.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "ddt/rect.h"
#include "plugin/tool/part/part.h"

namespace ddt::tool {

/// The type in which a part keeps numbers of `type` so that they come back; unknown if there is
/// none.
OIIO::TypeDesc stored_type(OIIO::TypeDesc type);

/// Whether a part can tell the name of a channel: it has a line for each.
bool is_kept_name(const std::string& channel);

/// What a part's file says about itself. The pixels are in tiles; the data window is the part's,
/// the display window the whole's.
struct PartHeader {
    std::string job; ///< fingerprint()
    Part part;
    Rect whole;       ///< the data window of the whole
    std::string type; ///< the whole's pixel type, where the file's holds more
    /// Of the whole's tiles, in pixels, where its format may have them; 0: it has none.
    int tile_width = 0, tile_height = 0;
    /// The channels' names in the whole's order: a file's are sorted. Empty: as the file has them.
    std::vector<std::string> channels;
    /// The whole's, as one run writes them. Those of the part's own file would not do: OpenEXR
    /// keeps none that belong to another format, and adds its own.
    OIIO::ParamValueList metadata;

    void write_to(OIIO::ImageSpec& spec) const;
    /// False if the spec is of no part.
    bool read_from(const OIIO::ImageSpec& spec);
};

/// Of a part of a whole that has this spec. job: fingerprint().
PartHeader header_of(const std::string& job, const Part& part, const OIIO::ImageSpec& whole);

} // namespace ddt::tool
