// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/format_limits.h"

#include <algorithm>
#include <iterator>

namespace ddt::tool {

int largest_side_of(const std::string& format) {
    return format == "jpeg" ? 65500 : format == "gif" ? 65535 : 0;
}

const char* other_channels(const std::string& format, int channels) {
    if (format == "dpx" && channels != 1 && channels != 3 && channels != 4)
        return "1, 3 and 4";
    return format == "jpeg" && channels == 2 ? "1 and 3" : nullptr;
}

bool holds_several(const OIIO::ImageOutput& output) {
    return output.supports("multiimage") && output.format_name() != std::string("fits");
}

const char* unlike(const std::string& format, const std::vector<OIIO::ImageSpec>& specs) {
    const auto all = [&](const auto& is_as_the_first) {
        return std::all_of(specs.begin(), specs.end(), [&](const OIIO::ImageSpec& spec) {
            return is_as_the_first(spec, specs[0]);
        });
    };
    using Spec = OIIO::ImageSpec;
    if (format == "gif" && !all([](const Spec& a, const Spec& b) {
            return a.width == b.width && a.height == b.height;
        }))
        return "size";
    if (format == "openexr" && !all([](const Spec& a, const Spec& b) {
            return a.full_x == b.full_x && a.full_y == b.full_y && a.full_width == b.full_width &&
                   a.full_height == b.full_height;
        }))
        return "display window";
    return nullptr;
}

void allow_large_tiff(std::vector<OIIO::ImageSpec>& specs) {
    OIIO::imagesize_t bytes = 0;
    for (const OIIO::ImageSpec& spec : specs)
        bytes += spec.image_bytes();
    if (bytes > (OIIO::imagesize_t(4000) << 20))
        for (OIIO::ImageSpec& spec : specs)
            spec.attribute("tiff:bigtiff", 1);
}

bool may_be_streamed(const std::string& format) {
    const auto& formats = streamed_formats;
    return std::find(std::begin(formats), std::end(formats), format) != std::end(formats);
}

} // namespace ddt::tool
