// SPDX-License-Identifier: Apache-2.0
// Files with which OpenImageIO's readers and writers do what nobody wants.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

namespace ddt {

/// Whether the file's reader, as TIFF's does, makes colours associated in numbers of the type that
/// it is asked for. Ask for floats, as oiiotool does: a small alpha leaves little of 8 bits.
inline bool is_associated_when_read(const OIIO::ImageSpec& native) {
    return native.get_int_attribute("tiff:UnassociatedAlpha") &&
           !native.get_int_attribute("oiio:UnassociatedAlpha") &&
           !native.format.is_floating_point() && native.format.size() <= 2;
}

/// Before pixels of a file are read. The reader of TIFF of OpenImageIO 2.4 says whether tiles were
/// inflated before its threads have tried.
inline void wait_for_tiles(OIIO::ImageInput& input) {
    if (OIIO::openimageio_version() < 20500 && input.format_name() == std::string("tiff"))
        input.threads(1);
}

/// Whether OpenImageIO's reader overruns its memory with the pixels: up to 3.1 with those of TIFFs
/// of CMYK in tiles, which have a channel more than what it makes of them.
inline bool overruns_memory(const OIIO::ImageSpec& native) {
    return OIIO::openimageio_version() < 30200 && native.tile_width > 0 && native.nchannels == 3 &&
           native.get_string_attribute("tiff:ColorSpace") == "CMYK";
}

/// What is said of such a file.
inline constexpr const char* why_overrun =
    "it has CMYK in tiles, with which OpenImageIO overruns its memory; in strips it can be read";

/// Whether OpenImageIO cannot read back a TIFF in tiles that it wrote with this attribute: its
/// reader overruns its memory with tiles of CMYK, and lacks the tables of those in JPEG.
inline bool spoils_tiff_tiles(const OIIO::ParamValue& attribute) {
    if (attribute.name() != "compression")
        return attribute.name() == "tiff:ColorSpace";
    const std::string compression = attribute.get_string();
    return compression.substr(0, compression.find(':')) == "jpeg";
}

} // namespace ddt
