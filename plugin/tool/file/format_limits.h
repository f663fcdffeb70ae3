// SPDX-License-Identifier: Apache-2.0
// What files of a format hold, where its writer neither looks at that nor says it.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

namespace ddt::tool {

/// Pixels a side that files of a format hold at most, where its writer does not say so: the JPEG
/// library ends the program, GIF's keeps the low bits. 0: it does, or there is no bound.
int largest_side_of(const std::string& format);

/// Null, or the numbers of channels that files of a format have, of which this is none and which
/// its writer does not look at: DPX's ends the program, JPEG's makes up a third of two.
const char* other_channels(const std::string& format, int channels);

/// Whether a file has room for several images. FITS's does, but the writer loses the rows of all
/// after the first (OpenImageIO 2.4.7).
bool holds_several(const OIIO::ImageOutput& output);

/// Null, or what the images of one file must have in common and have not. GIF's writer takes the
/// first one's size for that of all, and writes beyond its memory.
const char* unlike(const std::string& format, const std::vector<OIIO::ImageSpec>& specs);

/// TIFF's writer chooses by the size of the first image whether the file may be larger than 4 GiB.
void allow_large_tiff(std::vector<OIIO::ImageSpec>& specs);

/// Formats of which a file is right though its writer cannot go back in it. Of the others many
/// writers go back to lengths or rows, do not look whether that works, and leave a broken picture.
/// What EXR's goes back for, where its rows lie, readers find out.
inline constexpr const char* streamed_formats[] = {"gif",     "hdr", "iff", "jpeg",
                                                   "openexr", "png", "pnm", "webp"};

/// Whether a format is one of them.
bool may_be_streamed(const std::string& format);

} // namespace ddt::tool
