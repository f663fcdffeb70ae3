// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/prepare.h"

#include <algorithm>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imagebufalgo_util.h>

#include "core/base/memory/large_pages.h"
#include "core/base/one_line.h"
#include "ddt/rect.h"
#include "plugin/image/memory.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

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

bool check_source(const OIIO::ImageBuf& src, std::string& error) {
    if (!src.initialized()) {
        error = src.has_error() ? format("the source image cannot be read: {}", src.geterror(false))
                                : "the source image is uninitialised; give one that holds pixels";
        return false;
    }
    return check_source_spec(src.spec(), error) && check_pixels(src, error);
}

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
    } else if (roi.defined() && roi.depth() > 1) {
        error = format("the region is of depth {}, [{}, {}); allowed is depth 1", roi.depth(),
                       roi.zbegin, roi.zend);
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

} // namespace ddt
