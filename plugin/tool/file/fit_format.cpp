// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/fit_format.h"

#include <algorithm>
#include <vector>

#include <OpenImageIO/strutil.h>

#include "plugin/image/channels.h"
#include "plugin/image/oiio_defects.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"

namespace ddt::tool {

namespace {

/// Of the formats with alpha some have it beside red, green and blue alone.
bool takes_grey_with_alpha(const OIIO::ImageOutput& output) {
    const std::string format = output.format_name();
    return output.supports("alpha") && format != "bmp" && format != "jpeg2000";
}

bool may_have_tiles(const OIIO::ImageOutput& output, const OIIO::ImageSpec& spec) {
    // Writers hold whole tiles, several at once.
    constexpr OIIO::imagesize_t largest = 64 << 20;
    if (spec.tile_width < 1 || spec.tile_height < 1 || spec.tile_depth > 1 ||
        spec.tile_bytes(true) > largest)
        return false;
    const std::string type = output.format_name();
    const OIIO::ParamValueList& metadata = spec.extra_attribs;
    return type == "openexr" ||
           (type == "tiff" && spec.tile_width % 16 == 0 && spec.tile_height % 16 == 0 &&
            std::none_of(metadata.begin(), metadata.end(), spoils_tiff_tiles));
}

/// Whether the format's writer takes numbers of this type for others (OpenImageIO 2.4.7): for
/// integers, or, of FITS, for what cannot be read.
bool is_taken_for_another(const std::string& format, OIIO::TypeDesc type) {
    return (type == OIIO::TypeHalf && (format == "fits" || format == "rla")) ||
           (type == OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE) && format == "rla");
}

/// Have no types but those that come back from the file.
void fit_types(const OIIO::ImageOutput& output, OIIO::ImageSpec& spec) {
    const std::string format = output.format_name();
    // RLA's writer counts channels of several types wrong, and beyond their end (2.4.7).
    if (!output.supports("channelformats") || format == "rla")
        spec.channelformats.clear();
    if (is_taken_for_another(format, spec.format)) {
        spec.set_format(OIIO::TypeFloat);
        spec.erase_attribute("oiio:BitsPerSample"); // the image's own: of another type
    }
    // PNM's writer makes 8 bits of all types. Where it is told of more it takes two bytes for a
    // number then, also beyond their end; of one, red, green and blue for a row of bits (2.4.7).
    if (format == "pnm")
        spec.erase_attribute("oiio:BitsPerSample");
}

} // namespace

bool fit_format(const OIIO::ImageOutput& output, const std::string& path, OIIO::ImageSpec& spec,
                Failure& failure) {
    fit_types(output, spec);
    if (!may_have_tiles(output, spec))
        forget_tiles(spec);
    OIIO::ROI roi = spec.roi();
    if (!output.supports("displaywindow"))
        roi = spec.roi_full();
    if (!output.supports("negativeorigin")) {
        roi.xbegin = std::max(roi.xbegin, 0);
        roi.ybegin = std::max(roi.ybegin, 0);
    }
    if (roi.width() < 1 || roi.height() < 1) {
        failure = {"cannot write \"" + path + "\": no pixel has coordinates of 0 and more, and " +
                   output.format_name() + " holds no others"};
        return false;
    }
    spec.x = roi.xbegin;
    spec.y = roi.ybegin;
    spec.width = roi.width();
    spec.height = roi.height();
    return true;
}

std::string fit_channels(const OIIO::ImageOutput& output, OIIO::ImageSpec& spec) {
    spec.alpha_channel = alpha_of(spec);
    if (output.supports("nchannels"))
        return {};
    const std::vector<std::string>& names = spec.channelnames;
    const bool has_alpha = output.supports("alpha");
    const auto is_rgb = [&] { return names[0] == "R" && names[1] == "G" && names[2] == "B"; };
    int most = 3;
    if (has_alpha && (spec.alpha_channel == 3 || (spec.nchannels == 4 && !is_rgb())))
        most = 4;
    else if (!takes_grey_with_alpha(output) && spec.nchannels == 2 && spec.alpha_channel == 1)
        most = 1;
    // Where the first three are displayed, whatever they are called.
    const bool displaces_alpha =
        spec.nchannels >= 3 && spec.alpha_channel >= 0 && spec.alpha_channel < 3;
    std::string left_out = displaces_alpha ? names[size_t(spec.alpha_channel)] + " as alpha" : "";
    if (spec.nchannels <= most)
        return left_out;
    left_out += left_out.empty() ? "" : ", ";
    left_out += OIIO::Strutil::join(std::vector(names.begin() + most, names.end()), ", ");
    spec.nchannels = most;
    spec.channelnames.resize(size_t(most));
    if (!spec.channelformats.empty())
        spec.channelformats.resize(size_t(most));
    if (spec.alpha_channel >= most)
        spec.alpha_channel = -1;
    if (spec.z_channel >= most)
        spec.z_channel = -1;
    return left_out;
}

void note_left_out(const std::string& path, const std::string& channels) {
    if (!channels.empty())
        note("\"" + path + "\" has no room for " + channels);
}

void note_instead(const std::string& path, const char* what, const std::string& asked,
                  const std::string& written) {
    if (!asked.empty() && !written.empty() && asked != written)
        note(format("\"{}\" cannot have the {} {}; {} is written", path, what, asked, written));
}

} // namespace ddt::tool
