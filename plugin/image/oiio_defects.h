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

/// Whether a file, open or to be written, is a PFM, as PNM of floats is since OpenImageIO 2.5.12.
/// The last of its rows comes first. OpenImageIO's writer turns them about in each batch that it is
/// handed, if that is of floats, also where it makes whole numbers of them, unless it is told not
/// to; then it writes them as they come.
inline bool is_pfm(const std::string& format, const OIIO::ImageSpec& spec) {
    return OIIO::openimageio_version() >= 20512 && format == "pnm" &&
           spec.format.is_floating_point();
}

/// So that PNM's writer turns no rows about.
inline void keep_order_of_rows(OIIO::ImageSpec& spec) {
    spec.attribute("pnm:pfmflip", 0);
}

/// After a file was opened without hints: PFM's reader has its rows upside down then.
inline bool turn_rows_of_pfm(const std::string& path, OIIO::ImageInput& input) {
    if (!is_pfm(input.format_name(), input.spec()))
        return true;
    OIIO::ImageSpec spec;
    return input.close() && input.open(path, spec, OIIO::ImageSpec());
}

} // namespace ddt
