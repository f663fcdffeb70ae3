// SPDX-License-Identifier: Apache-2.0
// What the channels of an image are.
#pragma once

#include <vector>

#include <OpenImageIO/imageio.h>

#include "ddt/core.h"
#include "plugin/colour/layout.h"

namespace ddt {

/// The roles of an image's channels.
struct Channels {
    /// Colour that a colour space speaks of: find_colour() of those that are neither alpha, depth,
    /// an ink, of a vector, a slope nor an ID.
    ColourLayout colour;
    int alpha = -1; ///< the alpha of the image's colour, or -1
    /// Where no names tell its colour: up to three channels in which edges are sought instead, the
    /// first that are neither alpha nor an ID; depth where there is nothing else. Of CMYK all four.
    std::vector<int> guide;
    std::vector<Channel> kinds; ///< one a channel; nearest: an ID
    /// Pixels are 32-bit integers and travel as raw bits.
    bool raw = false;
};

/// True for the types whose numbers are IDs: 32-bit integers.
bool is_id_type(OIIO::TypeDesc type);

/// The image's alpha as its spec has it, or -1. Where the spec names a channel that there is not,
/// as OpenImageIO's reader of GIF does (2.4.7: 4 of 4), or the black of CMYK, as that of TIFF does,
/// or a slope, as maketx does, it is the one by the name of A or alpha.
int alpha_of(const OIIO::ImageSpec& spec);

/// `native` is of the file the pixels were read from: channels of 32-bit integers there are IDs,
/// even where a host has made floats of them.
Channels channels_of(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& native);
inline Channels channels_of(const OIIO::ImageSpec& spec) {
    return channels_of(spec, spec);
}

/// What a picture of the image shows: its colour, else the guide's first three channels as colour
/// if they are as many, else the first of them as grey.
ColourLayout shown_colour(const Channels& channels);

} // namespace ddt
