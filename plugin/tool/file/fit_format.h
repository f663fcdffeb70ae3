// SPDX-License-Identifier: Apache-2.0
// How much of an image a file's format has room for.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// Make the spec of an image what `output` can write of it into the file `path`, as oiiotool does:
/// where the format has no windows, the pixels of the display window; where it has no negative
/// coordinates, those of no other; types of single channels only where it has them, and its writer
/// writes them (not RLA's); floats for halfs in FITS and RLA, and for doubles in RLA, of which
/// their writers make files that are wrong or cannot be read (OpenImageIO 2.4.7), as PNM's does
/// where it is told of other bits than the 8 that it writes; and the tiles that it has, if it may
/// have them in that format and they take 64 MiB each or less, else none. (IFF has its own,
/// whatever it is asked for.) False with a failure if no pixel is left.
bool fit_format(const OIIO::ImageOutput& output, const std::string& path, OIIO::ImageSpec& spec,
                Failure& failure);

/// Ask for rows.
inline void forget_tiles(OIIO::ImageSpec& spec) {
    spec.tile_width = spec.tile_height = spec.tile_depth = 0;
}

/// Let the spec's alpha be the image's (alpha_of()), and leave out what comes after colour and
/// alpha, or alpha too, where the format holds no more, as oiiotool does (and alpha beside grey in
/// BMP and JPEG 2000); returns their names, if there are any. The format's writer, or
/// ImageFile::open(), complains about other channels than R, G, B and alpha in this order.
std::string fit_channels(const OIIO::ImageOutput& output, OIIO::ImageSpec& spec);

/// Say on stderr that the file `path` has no room for such channels, if there are any.
void note_left_out(const std::string& path, const std::string& channels);

/// Say on stderr that the file `path` has something else than was asked for, a "type" or
/// "compression". Silent if nothing was asked for, or if it is not known what was written.
void note_instead(const std::string& path, const char* what, const std::string& asked,
                  const std::string& written);

} // namespace ddt::tool
