// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/resize_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>

#include "core/tiles/crew_size.h"
#include "core/tiles/grid.h"
#include "plugin/image/metadata.h"
#include "plugin/image/reading.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/resample.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"
#include "plugin/tool/file/fit_format.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/picture.h"
#include "plugin/tool/ids/lost_ids.h"
#include "plugin/tool/ids/mixed_ids.h"
#include "plugin/tool/resize/row_reader.h"
#include "plugin/tool/resize/row_writer.h"
#include "plugin/tool/resize/size.h"
#include "plugin/tool/resize/tile_pixels.h"

namespace ddt::tool {

namespace {

/// Of the whole, as progress tells: what is left is writing.
constexpr float share_of_resizing = 0.8f;

/// What a process has once.
constexpr int64_t memory_of_process = int64_t(56) << 20;

/// Tiles for each thread in a strip that is resized while the one before is written: fewer, and
/// threads would wait for the last tiles of each.
constexpr int tiles_a_thread = 8;

/// Where strips of the pixels that are made end, the last at their end: at rows of tiles, so that
/// none is worked twice.
std::vector<int> strip_ends(const OIIO::ImageSpec& from, const OIIO::ImageSpec& to,
                            const OIIO::ROI& made, const ResizeSettings& settings) {
    const int last = made.yend;
    // Holes are filled before anything else, in the whole image; what does not grow has no tiles.
    if (settings.options.holes != Holes::keep || to.full_width < from.full_width ||
        to.full_height < from.full_height)
        return {last};
    const Grid grid(rect_of(OIIO::get_roi(from)));
    const int rows = 1 + tiles_a_thread * settings.threads / grid.columns();
    const ResizeMapping::Axis x = x_axis(from, to, made);
    const ResizeMapping::Axis y = y_axis(from, to, made);
    std::vector<int> ends;
    for (int row = rows; row < grid.rows(); row += rows) {
        const Rect strip{0, row - 1, grid.columns(), row};
        ends.push_back(pixels_of_tiles(strip, grid.columns(), grid.rows(), x, y).y1);
    }
    ends.push_back(last);
    return ends;
}

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

/// Open the file for what of the result its format has room for: `spec` becomes that.
bool open_file(const std::string& path, OIIO::ImageSpec& spec, ImageFile& file, Failure& failure) {
    spec.tile_width = spec.tile_height = spec.tile_depth = 0;
    if (!file.create(path, failure) || !fit_format(file.output(), path, spec, failure))
        return false;
    const std::string left_out = fit_channels(file.output(), spec);
    if (!check_size_of(spec, failure) || !file.open(spec, failure))
        return false;
    note_left_out(path, left_out);
    return true;
}

/// Make the image whose pixels an open file of this spec is written from. What the writer makes
/// other numbers of is held as floats, as oiiotool holds it: rounded once.
bool hold_result(OIIO::ImageSpec spec, ImageFile& file, OIIO::ImageBuf& result, Failure& failure) {
    if (file.output().spec().format != spec.format || !spec.channelformats.empty())
        spec.set_format(OIIO::TypeFloat);
    spec.channelformats.clear();
    if (!check_size_of(spec, failure))
        return false;
    if (take_memory(result, spec, failure.why))
        return true;
    failure.code = exit_resources;
    return false;
}

/// Resize the pixels `made` into the result, and let it be written strip by strip.
bool resize_strips(OIIO::ImageBuf& result, const OIIO::ImageBuf& image, const OIIO::ROI& made,
                   RowReader& reader, RowWriter& writer, const ResizeSettings& settings,
                   const std::function<bool(float)>& progress, Failure& failure) {
    int begin = made.ybegin;
    for (const int end : strip_ends(image.spec(), result.spec(), made, settings)) {
        if (end <= begin)
            continue;
        Options options = settings.options;
        options.progress = [&](float share) {
            const float rows = float(begin - made.ybegin) + share * float(end - begin);
            return !writer.has_failed() &&
                   progress(share_of_resizing * rows / float(made.height()));
        };
        OIIO::ROI roi = made;
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
    return true;
}

} // namespace

bool check_image(const OIIO::ImageBuf& image, const std::string& path, const Options& options,
                 Failure& failure) {
    if (check_source(image, failure.why) && check_options_of(image, options, failure.why))
        return true;
    failure.why = "\"" + path + "\": " + failure.why;
    failure.code = code_of_message(failure.why);
    return false;
}

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
    if (!settings.type.empty()) {
        spec.set_format(OIIO::TypeDesc(settings.type));
        spec.channelformats.clear();
        spec.erase_attribute("oiio:BitsPerSample"); // the image's own: of another type
    }
    if (!settings.compression.empty())
        spec.attribute("compression", settings.compression);
    return true;
}

bool resize_file(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 const std::function<bool(float)>& progress, Failure& failure) {
    OIIO::ImageBuf image;
    RowReader reader;
    if (!reader.begin(in, image, failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    // Before the file is open: writers complain by themselves when they get no pixels (PNG).
    if (!check_image(image, in, settings.options, failure))
        return false;
    const OIIO::ImageSpec from = spec_of_file(image);
    OIIO::ImageSpec spec;
    if (!plan_result(from, settings, spec, failure))
        return false;
    // Before the file is open, too.
    if (enlarges(image.roi_full(), spec.roi_full()) &&
        !check_light(image.spec(), image.nativespec(), settings.options, failure.why)) {
        failure.why = "\"" + in + "\": " + failure.why;
        return false;
    }
    OIIO::ROI made = OIIO::get_roi(spec);
    ImageFile file;
    OIIO::ImageBuf result;
    if (!open_file(out, spec, file, failure) || !hold_result(spec, file, result, failure))
        return false;
    made = OIIO::roi_intersection(made, result.roi());
    // Beyond its data window an image is black.
    if (made != result.roi() && !OIIO::ImageBufAlgo::zero(result)) {
        failure.why = result.geterror();
        return false;
    }
    note_lost_ids(image.nativespec(), file.output().spec(), out);
    MixedIds ids(in, image, file.output().spec());
    if (ids && !ids.put_into(image, failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    RowWriter writer(result, file, ids);
    if (made.width() > 0 && made.height() > 0 &&
        !resize_strips(result, image, made, reader, writer, settings, progress, failure))
        return false;
    if (!writer.has_failed())
        writer.ready(result.yend());
    const auto writing = [&](float share) {
        progress(share_of_resizing + share * (1 - share_of_resizing));
    };
    const std::string type = file.output().spec().format.c_str();
    if (!writer.finish(writing, failure) || !file.commit(failure))
        return false;
    note_instead(out, "type", settings.type, type);
    note_instead(out, "compression", settings.compression.substr(0, settings.compression.find(':')),
                 file.compression());
    note_others(in, reader.images());
    return true;
}

int64_t memory_to_resize(const std::string& in, const std::string& out,
                         const ResizeSettings& settings) {
    const auto file = OIIO::ImageInput::open(in);
    OIIO::ImageSpec spec;
    Failure failure;
    if (!file || !check_source_spec(file->spec(), failure.why) ||
        !plan_result(file->spec(), settings, spec, failure))
        return 0;
    const int64_t ids = count_mixed_ids(file->spec(), spec) *
                        int64_t(file->spec().image_pixels() * sizeof(uint32_t));
    // Another format than the source's may not hold its numbers (see hold_result()).
    if (!settings.type.empty() || !spec.channelformats.empty() ||
        OIIO::Filesystem::extension(in) != OIIO::Filesystem::extension(out))
        spec.set_format(OIIO::TypeFloat);
    OIIO::ImageSpec from = file->spec();
    if (is_associated_when_read(from))
        from.set_format(OIIO::TypeFloat);
    const auto beside =
        int64_t(memory_limit(size_t(settings.threads), settings.options.mesh.meshes));
    return int64_t(from.image_bytes() + spec.image_bytes()) + ids + beside + memory_of_process;
}

} // namespace ddt::tool
