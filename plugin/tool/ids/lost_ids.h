// SPDX-License-Identifier: Apache-2.0
// Object IDs that the file they are written to does not hold.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

namespace ddt::tool {

/// Names of channels, "id, mask00.R".
struct LostIds {
    std::string by_type;        ///< it has no room for them
    std::string by_compression; ///< it rounds them; others than those
};

/// The channels of object IDs, by plugin/image/channels.h, that do not come back from a file
/// that is written by this spec. Where the compression is the image's own, what it rounds was
/// rounded before, and counts as kept. image: the spec of its file; both have the same channels, of
/// which `written` may lack the last.
LostIds lost_ids(const OIIO::ImageSpec& image, const OIIO::ImageSpec& written);

/// Say on stderr which those are.
void note_lost_ids(const OIIO::ImageSpec& image, const OIIO::ImageSpec& written,
                   const std::string& path);

} // namespace ddt::tool
