// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/resize.h"

#include <algorithm>

#include <OpenImageIO/imagebufalgo_util.h>
#include <OpenImageIO/strutil.h>

#include "core/base/progress.h"
#include "core/fill/fill.h"
#include "plugin/image/channels.h"
#include "plugin/image/memory.h"
#include "plugin/image/prepare.h"
#include "plugin/image/reading.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/by_oiio.h"
#include "plugin/imagebuf/copy.h"
#include "plugin/imagebuf/guarded.h"
#include "plugin/imagebuf/holes.h"
#include "plugin/imagebuf/nearest.h"
#include "plugin/imagebuf/resample.h"
#include "plugin/imagebuf/shrink_axis.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

/// Bytes that the image between enlarging and shrinking may have, about.
constexpr int64_t band_bytes = int64_t(32) << 20;

/// Enlarge along the axis that grows into an image that still has the source's size along the
/// other, and shrink that.
bool enlarge_then_shrink(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                         bool shrink_x, const Options& options, int nthreads, std::string& error) {
    OIIO::ROI part = src.roi(), full = src.roi_full();
    if (shrink_x) {
        part.ybegin = roi.ybegin;
        part.yend = roi.yend;
        full.ybegin = dst.roi_full().ybegin;
        full.yend = dst.roi_full().yend;
    } else {
        part.xbegin = roi.xbegin;
        part.xend = roi.xend;
        full.xbegin = dst.roi_full().xbegin;
        full.xend = dst.roi_full().xend;
    }
    OIIO::ImageSpec spec = src.spec();
    spec.set_format(OIIO::TypeFloat); // rounding is left to the second step
    OIIO::set_roi(spec, part);
    OIIO::set_roi_full(spec, full);
    if (!check_size(part, spec.nchannels, spec.format, error))
        return false;
    OIIO::ImageBuf between;
    if (!make_image(between, spec, error))
        return false;
    const ResizeMapping mapping = mapping_of(src.spec(), spec, part);
    Options of_between = options;
    of_between.surface.clipped |= cuts_off(dst.spec().format);
    if (!resample(between, src, mapping, part, of_between, nthreads, error))
        return false;
    shrink_axis(dst, between, shrink_x, roi, nthreads);
    return true;
}

/// The same in bands across the axis that grows, so that what is between never is large.
bool enlarge_then_shrink_in_bands(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src,
                                  const OIIO::ROI& roi, bool shrink_x, const Options& options,
                                  int nthreads, std::string& error) {
    const int begin = shrink_x ? roi.ybegin : roi.xbegin, end = shrink_x ? roi.yend : roi.xend;
    const int64_t line = int64_t(shrink_x ? src.spec().width : src.spec().height) *
                         src.nchannels() * int64_t(sizeof(float));
    const int band = int(std::min<int64_t>(end - begin, std::max<int64_t>(band_bytes / line, 16)));
    Statistics all, of_band;
    for (int at = begin; at < end; at += band) {
        const int n = std::min(band, end - at);
        OIIO::ROI part = roi;
        (shrink_x ? part.ybegin : part.xbegin) = at;
        (shrink_x ? part.yend : part.xend) = at + n;
        Options of_part = options;
        of_part.statistics = &of_band;
        const auto share_at = [&](int y) { return float(y - begin) / float(end - begin); };
        of_part.progress = part_of(options.progress, share_at(at), share_at(at + n));
        if (!enlarge_then_shrink(dst, src, part, shrink_x, of_part, nthreads, error))
            return false;
        all += of_band;
        all.device = of_band.device;
    }
    if (options.statistics)
        *options.statistics = all;
    return true;
}

/// OpenImageIO's resize ends the process where a filter has 2^20 weights and more, which its widest
/// has at some 170000 source pixels to one of the result; it counts all weights of a row in an int.
bool check_shrinking(const OIIO::ROI& from, const OIIO::ROI& to, const OIIO::ROI& roi,
                     std::string& error) {
    constexpr double most_times = 65536, weights = 8, most_weights = 1 << 30;
    const double across = std::max(double(from.width()) / to.width(), 1.0);
    const double down = double(from.height()) / to.height();
    const double most_columns = most_weights / (weights * across + 1);
    if (across <= most_times && down <= most_times && roi.width() <= most_columns)
        return true;
    error = format("{} x {} pixels cannot be shrunk to {} x {}; allowed are "
                   "{:.0f} times along an axis, and {:.0f} columns at once",
                   from.width(), from.height(), to.width(), to.height(), most_times, most_columns);
    return false;
}

bool resize_checked(OIIO::ImageBuf& dst, const OIIO::ImageBuf& given, Arrival* arrival,
                    const Options& options, OIIO::ROI roi, int nthreads, OIIO::ROI& touched,
                    std::string& error) {
    using namespace OIIO::ImageBufAlgo;
    if (!check_options_of(given, options, error) ||
        !prepare(dst, given, roi, IBAprep_NO_SUPPORT_VOLUME | IBAprep_NO_COPY_ROI_FULL, error))
        return false;
    if (roi.width() <= 0)
        return true;
    const OIIO::ROI from = given.roi_full(), to = dst.roi_full();
    if (to.width() < 1 || to.height() < 1) {
        error =
            format("the destination's display window has {} x {} pixels; at least 1 x 1 is needed",
                   to.width(), to.height());
        return false;
    }
    const bool shrink_x = to.width() < from.width(), shrink_y = to.height() < from.height();
    const bool grow_x = to.width() > from.width(), grow_y = to.height() > from.height();
    if ((shrink_x || shrink_y) && !check_shrinking(from, to, roi, error))
        return false;
    touched = roi;
    if (enlarges(from, to)) {
        const ResizeMapping mapping = mapping_of(given.spec(), dst.spec(), roi);
        return resample(dst, given, mapping, roi, options, nthreads, error, arrival);
    }
    if (arrival && !arrival->wait_for(given.roi().yend, error))
        return false;
    const bool grow = grow_x || grow_y;
    Options of_holes = options;
    of_holes.progress = part_of(options.progress, 0, grow ? share_of_filling : 1);
    OIIO::ImageBuf filled;
    if (!fill_image(given, of_holes, options.holes, type_between(given), filled, nthreads, error))
        return false;
    const OIIO::ImageBuf& src = filled.initialized() ? filled : given;
    if (!grow && !shrink_x && !shrink_y)
        return copy_moved(dst, src, roi, to.xbegin - from.xbegin, to.ybegin - from.ybegin,
                          Beyond::edge, error);
    bool shrunk = all_are_ids(src, roi); // nothing to shrink
    if (!shrunk && grow) {
        Options of_filled = options;
        of_filled.holes = Holes::keep;
        of_filled.progress =
            part_of(options.progress, filled.initialized() ? share_of_filling : 0, 1);
        shrunk = enlarge_then_shrink_in_bands(dst, src, roi, shrink_x, of_filled, nthreads, error);
    } else if (!shrunk) {
        shrunk = resize_by_oiio(dst, src, roi, nthreads, error);
    }
    return shrunk && copy_nearest_ids(dst, src, roi, error);
}

} // namespace

bool resize(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options, OIIO::ROI roi,
            int nthreads) {
    return resize_arriving(dst, src, nullptr, options, roi, nthreads);
}

bool resize_arriving(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, Arrival* arrival,
                     const Options& options, OIIO::ROI roi, int nthreads) {
    return guarded_from(dst, src, [&](const auto& from, OIIO::ROI& touched, std::string& error) {
        return resize_checked(dst, from, arrival, options, roi, nthreads, touched, error);
    });
}

} // namespace ddt
