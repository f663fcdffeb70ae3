// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/windows.h"

#include <algorithm>
#include <limits>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imagebufalgo_util.h>
#include <OpenImageIO/strutil.h>
#include <OpenImageIO/sysutil.h>

#include "core/base/control_groups.h"
#include "core/base/memory/large_pages.h"
#include "core/base/one_line.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

/// So much is there wherever this runs. To ask the system takes up to a tenth of a small image's
/// time.
constexpr int64_t surely_available = 64;

int64_t allowed_megabytes(double wanted) {
    const int64_t memory =
        wanted <= double(surely_available) ? surely_available : available_memory() >> 20;
    int limit = 0;
    if (!OIIO::getattribute("limits:imagesize_MB", limit) || limit <= 0)
        return memory;
    return std::min<int64_t>(limit, memory);
}

/// `whose`: "source's" or "destination's"; what has no display window is no source.
bool check_windows(const char* whose, const OIIO::ImageSpec& spec, int least_display,
                   std::string& error) {
    const auto fits = [&](const char* which, int64_t begin, int64_t size, int least) {
        if (size >= least && begin >= -largest_coordinate && begin + size <= largest_coordinate)
            return true;
        error = format("the {} {} window has size {} at {}; allowed are sizes of {} and more "
                       "within +-{}",
                       whose, which, size, begin, least, largest_coordinate);
        return false;
    };
    return fits("data", spec.x, spec.width, 1) && fits("data", spec.y, spec.height, 1) &&
           fits("display", spec.full_x, spec.full_width, least_display) &&
           fits("display", spec.full_y, spec.full_height, least_display);
}

/// What IBAprep does with a roi and a dst that is not initialised, less making pixels black of
/// which all will be written: that would take a tenth of the filter's time.
bool allocate(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::ROI& roi, int flags,
              std::string& error) {
    const OIIO::ROI whole = roi;
    roi.xend = roi.xbegin + 1;
    roi.yend = roi.ybegin + 1;
    OIIO::ImageBuf pixel; // of what dst is to be like
    if (!OIIO::ImageBufAlgo::IBAprep(roi, &pixel, &src, flags)) {
        error = pixel.geterror();
        return false;
    }
    OIIO::ImageSpec spec = pixel.spec();
    roi.xend = whole.xend;
    roi.yend = whole.yend;
    OIIO::set_roi(spec, roi);
    if (flags & OIIO::ImageBufAlgo::IBAprep_NO_COPY_ROI_FULL)
        OIIO::set_roi_full(spec, roi);
    const bool all = roi.chbegin <= 0 && roi.chend >= spec.nchannels;
    if (!take_memory(dst, spec, error))
        return false;
    ask_for_large_pages(dst.localpixels(), dst.spec().image_bytes());
    if (!all)
        OIIO::ImageBufAlgo::zero(dst);
    return true;
}

/// Whether the roi has any of the channels that the images have, both of them.
bool check_channels(const OIIO::ROI& roi, const OIIO::ImageBuf& dst, const OIIO::ImageBuf& src,
                    std::string& error) {
    const int channels =
        dst.initialized() ? std::min(src.nchannels(), dst.nchannels()) : src.nchannels();
    if (!roi.defined() || std::max(roi.chbegin, 0) < std::min(roi.chend, channels))
        return true;
    error = format("the range of channels [{}, {}) has none of the image's {}; allowed are ranges "
                   "with some of [0, {})",
                   roi.chbegin, roi.chend, channels, channels);
    return false;
}

/// OpenImageIO 3 reads a file into memory when its pixels are first asked for, which is now; any
/// version leaves black what it could not read. An error that comes from elsewhere, on an image
/// that has its pixels, is no reason to fail.
bool check_pixels(const OIIO::ImageBuf& src, std::string& error) {
    if (src.pixels_valid())
        return true;
    // Once it has failed, 2.4 does not fail again.
    if (!src.has_error())
        src.localpixels();
    if (src.has_error())
        error = format("the source image cannot be read: {}", src.geterror(false));
    return error.empty();
}

} // namespace

int64_t available_memory() {
    auto bytes = int64_t(OIIO::Sysutil::physical_memory());
    if (bytes == 0) // not known: no /proc
        bytes = std::numeric_limits<int64_t>::max();
    return std::min(bytes, memory_of_groups());
}

bool check_source(const OIIO::ImageBuf& src, std::string& error) {
    if (!src.initialized()) {
        error = src.has_error() ? format("the source image cannot be read: {}", src.geterror(false))
                                : "the source image is uninitialised; give one that holds pixels";
        return false;
    }
    return check_source_spec(src.spec(), error) && check_pixels(src, error);
}

namespace {

/// Whether images of this type can be read and written. whose: "source's", say.
bool check_type(const char* whose, OIIO::TypeDesc type, std::string& error) {
    switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
    case OIIO::TypeDesc::UINT32:
    case OIIO::TypeDesc::INT32:
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::DOUBLE:
        return true;
    default:
        error = format("the {} pixels are {}; allowed are 8 to 32-bit integers, half, float "
                       "and double",
                       whose, type.c_str());
        return false;
    }
}

} // namespace

bool check_source_spec(const OIIO::ImageSpec& spec, std::string& error) {
    if (spec.deep) {
        error = "the source is a deep image; allowed are flat ones";
        return false;
    }
    if (spec.depth > 1 || spec.full_depth > 1) {
        error = format("the source is a volume of depth {}; allowed is depth 1",
                       std::max(spec.depth, spec.full_depth));
        return false;
    }
    if (spec.nchannels < 1) {
        error = "the source has no channels; at least 1 is needed";
        return false;
    }
    if (!check_type("source's", spec.format, error))
        return false;
    return check_windows("source's", spec, 1, error);
}

bool check_memory(const std::string& what, double bytes, std::string& error) {
    const double megabytes = bytes / (1 << 20);
    const int64_t allowed = allowed_megabytes(megabytes);
    if (megabytes <= double(allowed))
        return true;
    error =
        format("{} would need {:.0f} MB; allowed are {} MB (the least of OpenImageIO's "
               "limits:imagesize_MB, this machine's memory and what control groups allow of it)",
               what, megabytes, allowed);
    return false;
}

bool check_size(const OIIO::ROI& roi, int channels, OIIO::TypeDesc type, std::string& error) {
    const int64_t width = int64_t(roi.xend) - roi.xbegin, height = int64_t(roi.yend) - roi.ybegin;
    if (width < 1 || height < 1) {
        error =
            format("the output would be {} x {} pixels; at least 1 x 1 is needed", width, height);
        return false;
    }
    if (!rect_of(roi).within_limits()) {
        error = format("the output would be {} x {} pixels; coordinates are allowed within +-{}",
                       width, height, largest_coordinate);
        return false;
    }
    // As a double: the bytes may pass 2^63 by way of channels.
    return check_memory(format("the output of {} x {} pixels, {} channels, {}", width, height,
                               channels, type.c_str()),
                        double(width) * double(height) * double(channels) * double(type.size()),
                        error);
}

bool take_memory(OIIO::ImageBuf& image, const OIIO::ImageSpec& spec, std::string& error) {
    image.reset(spec, OIIO::InitializePixels::No);
    if (image.localpixels())
        return true;
    image.geterror(); // 3.x prints what nobody asked for
    image.clear();
    error = out_of_memory_text;
    return false;
}

bool make_image(OIIO::ImageBuf& image, const OIIO::ImageSpec& spec, std::string& error) {
    return take_memory(image, spec, error) && OIIO::ImageBufAlgo::zero(image);
}

bool prepare(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::ROI& roi, int flags,
             std::string& error) {
    if (!check_channels(roi, dst, src, error))
        return false;
    if (dst.initialized()) {
        if (dst.deep() || dst.spec().depth > 1) {
            error = "the destination is a deep image or a volume; only flat images can be written";
            return false;
        }
        if (!check_type("destination's", dst.spec().format, error) ||
            !check_windows("destination's", dst.spec(), 0, error))
            return false;
    } else if (!check_size(roi.defined() ? roi : src.roi(), src.nchannels(), src.spec().format,
                           error)) {
        return false;
    }
    if (!dst.initialized() && roi.defined()) {
        if (!allocate(dst, src, roi, flags, error))
            return false;
    } else if (!OIIO::ImageBufAlgo::IBAprep(roi, &dst, &src, flags) || !dst.localpixels()) {
        error = dst.has_error() ? dst.geterror() : out_of_memory_text;
        return false;
    }
    roi.chend = std::min(roi.chend, std::min(src.nchannels(), dst.nchannels()));
    roi.chbegin = std::max(roi.chbegin, 0);
    if (roi.width() <= 0 || roi.height() <= 0 || roi.depth() <= 0 || roi.chbegin >= roi.chend)
        roi.xend = roi.xbegin;
    return true;
}

namespace {

/// Cut begin .. end to the output pixels that the enlarged data window touches, on either side
/// where that ends within the display window.
void cut_to_data(int from0, int from_size, int window0, int window_size, int to0, int to_size,
                 int& begin, int& end) {
    const auto moved = [&](int from) { return int64_t(from - from0) * to_size; };
    if (window0 > from0)
        begin = int(std::max<int64_t>(begin, to0 + moved(window0) / from_size));
    if (window0 + window_size < from0 + from_size) {
        const int64_t last = moved(window0 + window_size);
        const int64_t up = last > 0 ? (last + from_size - 1) / from_size : last / from_size;
        end = int(std::min<int64_t>(end, to0 + up));
    }
}

} // namespace

OIIO::ROI cut_to_data(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst, OIIO::ROI roi) {
    if (dst.full_width >= src.full_width)
        cut_to_data(src.full_x, src.full_width, src.x, src.width, dst.full_x, dst.full_width,
                    roi.xbegin, roi.xend);
    if (dst.full_height >= src.full_height)
        cut_to_data(src.full_y, src.full_height, src.y, src.height, dst.full_y, dst.full_height,
                    roi.ybegin, roi.yend);
    roi.xend = std::max(roi.xbegin, roi.xend);
    roi.yend = std::max(roi.ybegin, roi.yend);
    return roi;
}

ResizeMapping::Axis x_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi) {
    return {src.full_x, src.full_width,    dst.full_x, dst.full_width,
            src.x,      src.x + src.width, roi.xbegin, roi.xend};
}

ResizeMapping::Axis y_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi) {
    return {src.full_y, src.full_height,    dst.full_y, dst.full_height,
            src.y,      src.y + src.height, roi.ybegin, roi.yend};
}

} // namespace ddt
