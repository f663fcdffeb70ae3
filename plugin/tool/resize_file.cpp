// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/tiles/grid.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/resample.h"
#include "plugin/tool/image_file.h"
#include "plugin/tool/part.h"
#include "plugin/tool/row_reader.h"
#include "plugin/tool/row_writer.h"
#include "plugin/tool/size.h"

namespace ddt::tool {

namespace {

/// Of the whole, as progress tells: what is left is writing.
constexpr float share_of_resizing = 0.8f;

/// What enlarging takes at most beside input and output: as ddt/job.h says, and what a process has
/// once.
int64_t memory_beside(int threads) {
    constexpr int64_t mib = int64_t(1) << 20;
    return std::max(200 * mib, threads * 6 * mib) + 56 * mib;
}

/// Tiles for each thread in a strip that is resized while the one before is written: fewer, and
/// threads would wait for the last tiles of each.
constexpr int tiles_a_thread = 8;

/// Where strips of the result end, the last at its end: at rows of tiles, so that none is worked
/// twice.
std::vector<int> strip_ends(const OIIO::ImageSpec& from, const OIIO::ImageSpec& to,
                            const ResizeSettings& settings) {
    const int last = to.y + to.height;
    // Holes are filled before anything else, in the whole image; what does not grow has no tiles.
    if (settings.options.holes != Holes::keep || to.full_width < from.full_width ||
        to.full_height < from.full_height)
        return {last};
    const Grid grid(rect_of(OIIO::get_roi(from)));
    const int rows = 1 + tiles_a_thread * settings.threads / grid.columns();
    const ResizeMapping::Axis x = x_axis(from, to, OIIO::get_roi(to));
    const ResizeMapping::Axis y = y_axis(from, to, OIIO::get_roi(to));
    std::vector<int> ends;
    for (int row = rows; row < grid.rows(); row += rows) {
        const Rect strip{0, row - 1, grid.columns(), row};
        ends.push_back(pixels_of_tiles(strip, grid.columns(), grid.rows(), x, y).y1);
    }
    ends.push_back(last);
    return ends;
}

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
    if (!settings.compression.empty())
        spec.attribute("compression", settings.compression);
    return true;
}

Failure refused_size(const std::string& size) {
    return {"size \"" + size + "\" is not allowed; allowed are " + allowed_sizes, exit_usage};
}

bool resize_file(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 const std::function<bool(float)>& progress, Failure& failure) {
    OIIO::ImageBuf image;
    RowReader reader;
    if (!reader.begin(in, image, failure.why)) {
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
    if (!take_memory(result, spec, failure.why)) {
        failure.code = exit_resources;
        return false;
    }
    ImageFile file;
    if (!file.begin(out, spec, failure))
        return false;
    RowWriter writer(result, file);
    int begin = spec.y;
    for (const int end : strip_ends(image.spec(), spec, settings)) {
        Options options = settings.options;
        options.progress = [&](float share) {
            const float rows = float(begin - spec.y) + share * float(end - begin);
            return !writer.has_failed() && progress(share_of_resizing * rows / float(spec.height));
        };
        OIIO::ROI roi = result.roi();
        roi.ybegin = begin;
        roi.yend = end;
        if (!resize_arriving(result, image, &reader, options, roi, settings.threads) &&
            !writer.has_failed()) {
            failure.why = result.geterror();
            failure.code = code_of_message(failure.why);
            return false;
        }
        if (writer.has_failed()) {
            result.geterror(); // that it was cancelled: 3.x prints what nobody asked for
            break;
        }
        writer.ready(end);
        begin = end;
    }
    const auto writing = [&](float share) {
        progress(share_of_resizing + share * (1 - share_of_resizing));
    };
    return writer.finish(writing, failure) && file.commit(failure);
}

int64_t memory_to_resize(const std::string& in, const ResizeSettings& settings) {
    const auto file = OIIO::ImageInput::open(in);
    OIIO::ImageSpec spec;
    if (!file || !plan_result(file->spec(), settings, spec))
        return 0;
    return int64_t(file->spec().image_bytes() + spec.image_bytes()) +
           memory_beside(settings.threads);
}

} // namespace ddt::tool
