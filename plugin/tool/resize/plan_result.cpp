// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/plan_result.h"

#include <cmath>

#include "plugin/image/metadata.h"
#include "plugin/message/format.h"
#include "plugin/tool/resize/size.h"

namespace ddt::tool {

namespace {

/// n * to / from, rounded down.
int64_t scaled_down(int64_t n, int64_t to, int64_t from) {
    return n * to / from - (n * to % from < 0 ? 1 : 0);
}

/// An axis of a data window that is scaled along with its display window: its origin rounded down,
/// its size up. False if that is beyond what coordinates are allowed.
bool scale_axis(int full_from, int full_size_from, int full_to, int full_size_to, int& begin,
                int& size) {
    const int64_t first =
        full_to + scaled_down(int64_t(begin) - full_from, full_size_to, full_size_from);
    const int64_t count = -scaled_down(-int64_t(size), full_size_to, full_size_from);
    if (first < -largest_coordinate || first + count > largest_coordinate)
        return false;
    begin = int(first);
    size = int(count);
    return true;
}

/// Say with which level of DWA the source was compressed, which is said beside the compression.
void keep_level(OIIO::ImageSpec& spec) {
    const std::string compression = spec.get_string_attribute("compression");
    const float level = spec.get_float_attribute("openexr:dwaCompressionLevel", -1);
    if ((compression == "dwaa" || compression == "dwab") && level >= 0)
        spec.attribute("compression", format("{}:{:g}", compression, level));
}

Failure too_far(const OIIO::ImageSpec& from, const Size& size) {
    return {format(
        "the output would be {:.0f} x {:.0f} pixels; coordinates are allowed within +-{}",
        std::ceil(from.width * (double(size.width) / from.full_width)),
        std::ceil(from.height * (double(size.height) / from.full_height)), largest_coordinate)};
}

} // namespace

bool plan_result(const OIIO::ImageSpec& from, const ResizeSettings& settings, OIIO::ImageSpec& spec,
                 Failure& failure) {
    Size size;
    if (!parse_size(settings.size, {from.full_width, from.full_height, from.full_x, from.full_y},
                    size)) {
        failure = {wrong_size(settings.size), exit_usage};
        return false;
    }
    spec = from;
    forget_pixels(spec);
    keep_level(spec);
    if (size.width != from.full_width || size.height != from.full_height) {
        if (!scale_axis(from.full_x, from.full_width, size.x, size.width, spec.x, spec.width) ||
            !scale_axis(from.full_y, from.full_height, size.y, size.height, spec.y, spec.height)) {
            failure = too_far(from, size);
            return false;
        }
        spec.full_x = size.x;
        spec.full_y = size.y;
        spec.full_width = size.width;
        spec.full_height = size.height;
    }
    forget_old_size(spec);
    if (!settings.type.empty()) {
        spec.set_format(OIIO::TypeDesc(settings.type));
        spec.channelformats.clear();
        spec.erase_attribute("oiio:BitsPerSample"); // the image's own: of another type
    }
    if (!settings.compression.empty())
        spec.attribute("compression", settings.compression);
    return true;
}

} // namespace ddt::tool
