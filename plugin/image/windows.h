// SPDX-License-Identifier: Apache-2.0
// The windows of a call: checks of the images, the destination's preparation, the axes' mapping.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"

namespace ddt {

/// False with one line in `error` unless `src` is an image the filters can work on: readable, flat,
/// not a volume, not empty, of numbers OpenImageIO converts.
bool check_source(const OIIO::ImageBuf& src, std::string& error);
/// The same before pixels are read.
bool check_source_spec(const OIIO::ImageSpec& spec, std::string& error);

/// Bytes that this process may have: the machine's memory, or what its control groups allow of it.
int64_t available_memory();

/// False with one line in `error` unless an image of `roi`'s size may be allocated: coordinates
/// within +-largest_coordinate, and no more bytes than OpenImageIO's attribute
/// "limits:imagesize_MB" or available_memory() allows.
bool check_size(const OIIO::ROI& roi, int channels, OIIO::TypeDesc format, std::string& error);
/// The same of so many bytes for something else: "comparing 640 x 480 pixels".
bool check_memory(const std::string& what, double bytes, std::string& error);

/// Make `image` one as `spec` says, its pixels not yet written. False with one line in `error` when
/// there is no memory: OpenImageIO 3 then calls an image initialised that has no pixels.
bool take_memory(OIIO::ImageBuf& image, const OIIO::ImageSpec& spec, std::string& error);

/// The same with black pixels.
bool make_image(OIIO::ImageBuf& image, const OIIO::ImageSpec& spec, std::string& error);

/// Make `dst` ready to be written and `roi` what is to be written of it, as ImageBufAlgo does (the
/// flags are IBAprep's): an initialised dst keeps its size and cuts the roi; another is allocated
/// for the roi, or like src without one. The size and the roi's channels are checked before. False
/// with one line in `error`. A roi that misses dst comes back empty.
bool prepare(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::ROI& roi, int flags,
             std::string& error);

/// The pixels of a roi.
inline Rect rect_of(const OIIO::ROI& roi) {
    return {roi.xbegin, roi.ybegin, roi.xend, roi.yend};
}

/// `roi`, of dst's pixels, without those that src's enlarged data window does not touch: where it
/// ends within the display window, along axes that do not shrink. May be empty.
OIIO::ROI cut_to_data(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst, OIIO::ROI roi);

/// src's display window mapped onto dst's, `roi` of dst's pixels wanted.
ResizeMapping::Axis x_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi);
ResizeMapping::Axis y_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi);

} // namespace ddt
