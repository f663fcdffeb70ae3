// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/resize_image.h"

#include <vector>

#include <OpenImageIO/imagebufalgo.h>

#include "core/base/progress.h"
#include "core/tiles/grid.h"
#include "plugin/image/memory.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/resize.h"
#include "plugin/tool/file/check_image.h"
#include "plugin/tool/ids/lost_ids.h"
#include "plugin/tool/ids/mixed_ids.h"
#include "plugin/tool/resize/row_writer.h"
#include "plugin/tool/resize/tile_pixels.h"

namespace ddt::tool {

namespace {

/// Of the whole, as progress tells: what is left is writing.
constexpr float share_of_resizing = 0.8f;

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

/// Whether the writer divides colour by alpha before it rounds, as PNG's does since
/// OpenImageIO 2.5.
bool divides_floats(const OIIO::ImageOutput& output) {
    const OIIO::ImageSpec& spec = output.spec();
    return OIIO::openimageio_version() >= 20500 && output.format_name() == std::string("png") &&
           spec.alpha_channel >= 0 && !spec.get_int_attribute("oiio:UnassociatedAlpha");
}

/// Make the image whose pixels an open file of this spec is written from. What the writer makes
/// other numbers of is held as floats, as oiiotool holds it: rounded once.
bool hold_result(OIIO::ImageSpec spec, ImageFile& file, OIIO::ImageBuf& result, Failure& failure) {
    if (file.output().spec().format != spec.format || !spec.channelformats.empty() ||
        divides_floats(file.output()))
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
                   const ProgressCallback& progress, Failure& failure) {
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

bool resize_image(ArrivingImage& source, const OIIO::ROI& wanted, const OIIO::ImageSpec& spec,
                  ImageFile& file, const ResizeSettings& settings, const ProgressCallback& progress,
                  Failure& failure) {
    OIIO::ImageBuf& image = source.image;
    OIIO::ImageBuf result;
    if (!hold_result(spec, file, result, failure))
        return false;
    ResizeSettings own = settings;
    // As results of whole numbers are, in whatever they are held.
    own.options.surface.clipped |=
        divides_floats(file.output()) && file.output().spec().format == spec.format;
    const OIIO::ROI made = OIIO::roi_intersection(wanted, result.roi());
    // Beyond its data window an image is black.
    if (made != result.roi() && !OIIO::ImageBufAlgo::zero(result)) {
        failure.why = result.geterror();
        return false;
    }
    note_lost_ids(image.nativespec(), file.output().spec(), file.path());
    MixedIds ids(source.path, source.number, image, file.output().spec());
    if (ids && !ids.put_into(image, failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    RowWriter writer(result, file, ids);
    if (made.width() > 0 && made.height() > 0 &&
        !resize_strips(result, image, made, source.reader, writer, own, progress, failure))
        return false;
    if (!writer.has_failed())
        writer.ready(result.yend());
    return writer.finish(part_of(progress, share_of_resizing, 1), failure);
}

} // namespace ddt::tool
