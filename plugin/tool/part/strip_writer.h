// SPDX-License-Identifier: Apache-2.0
// Pixels of a part, made and written strip by strip.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "ddt/rect.h"
#include "ddt/resize.h"
#include "plugin/tool/ids/mixed_ids.h"

namespace ddt::tool {

/// Enlarges a part in strips and hands on whole rows of the file's tiles.
class StripWriter {
public:
    /// `ids`: those of the source, if any.
    StripWriter(const OIIO::ImageSpec& whole, const Rect& part, int tile_height,
                OIIO::ImageOutput& output, MixedIds& ids);

    /// The part's rows up to `end`, of a source that has what they show, in these of its pixels.
    /// False with a line in `error`, or in the output's geterror().
    bool strip(int end, const OIIO::ImageBuf& source, const Rect& shown, const Options& options,
               int threads, std::string& error);

private:
    bool make(OIIO::ImageBuf& strip, const OIIO::ImageBuf& source, const Rect& shown,
              const Options& options, int threads) const;
    bool write(int rows, OIIO::TypeDesc type, const char* pixels);

    OIIO::ImageSpec m_spec;
    const Rect m_part;
    const int m_tile_height;
    OIIO::ImageOutput& m_output;
    MixedIds& m_ids;
    int m_done;               ///< rows before are written
    int m_made;               ///< rows before are enlarged
    std::vector<char> m_left; ///< those between
};

} // namespace ddt::tool
