// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize_file.h"

#include <cmath>

#include "plugin/image/windows.h"
#include "plugin/tool/image_file.h"
#include "plugin/tool/picture.h"
#include "plugin/tool/size.h"

namespace ddt::tool {

namespace {

/// Of the whole, as progress tells: what is left is writing.
constexpr float share_of_resizing = 0.8f;

/// What enlarging takes at most beside input and output.
constexpr int64_t memory_beside = int64_t(256) << 20;

} // namespace

bool plan_result(const OIIO::ImageSpec& from, const ResizeSettings& settings,
                 OIIO::ImageSpec& spec) {
    Size size;
    if (!parse_size(settings.size, {from.full_width, from.full_height, from.full_x, from.full_y},
                    size))
        return false;
    spec = from;
    if (size.width != from.full_width || size.height != from.full_height) {
        const double across = double(size.width) / from.full_width;
        const double down = double(size.height) / from.full_height;
        spec.x = size.x + int(std::floor((from.x - from.full_x) * across));
        spec.y = size.y + int(std::floor((from.y - from.full_y) * down));
        spec.width = int(std::ceil(from.width * across));
        spec.height = int(std::ceil(from.height * down));
        spec.full_x = size.x;
        spec.full_y = size.y;
        spec.full_width = size.width;
        spec.full_height = size.height;
    }
    if (!settings.type.empty()) {
        spec.set_format(OIIO::TypeDesc(settings.type));
        spec.channelformats.clear();
    }
    return true;
}

Failure refused_size(const std::string& size) {
    return {"size \"" + size + "\" is not allowed; allowed are " + allowed_sizes, exit_usage};
}

bool resize_file(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 const std::function<bool(float)>& progress, Failure& failure) {
    OIIO::ImageBuf image;
    if (!open_image(in, image, failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    OIIO::ImageSpec spec;
    if (!plan_result(image.spec(), settings, spec)) {
        failure = refused_size(settings.size);
        return false;
    }
    if (!check_size(OIIO::get_roi(spec), spec.nchannels, spec.format, failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    OIIO::ImageBuf result;
    result.reset(spec, OIIO::InitializePixels::No);
    if (!result.initialized()) {
        failure = {"out of memory", exit_resources};
        return false;
    }
    Options options = settings.options;
    options.progress = [&](float share) { return progress(share * share_of_resizing); };
    if (!resize(result, image, options, result.roi(), settings.threads)) {
        failure.why = result.geterror();
        failure.code = code_of_message(failure.why);
        return false;
    }
    image.clear();
    const auto writing = [&](float share) {
        progress(share_of_resizing + share * (1 - share_of_resizing));
    };
    return write_image(result, out, writing, failure);
}

int64_t memory_to_resize(const std::string& in, const ResizeSettings& settings) {
    const auto file = OIIO::ImageInput::open(in);
    OIIO::ImageSpec spec;
    if (!file || !plan_result(file->spec(), settings, spec))
        return 0;
    return int64_t(file->spec().image_bytes() + spec.image_bytes()) + memory_beside;
}

} // namespace ddt::tool
