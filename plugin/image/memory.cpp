// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/memory.h"

#include <algorithm>
#include <limits>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/sysutil.h>

#include "core/base/control_groups.h"
#include "core/base/one_line.h"
#include "plugin/image/windows.h"
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

} // namespace

int64_t available_memory() {
    auto bytes = int64_t(OIIO::Sysutil::physical_memory());
    if (bytes == 0) // not known: no /proc
        bytes = std::numeric_limits<int64_t>::max();
    return std::min(bytes, memory_of_groups());
}

bool check_memory(const std::string& what, double bytes, std::string& error) {
    const double megabytes = bytes / (1 << 20);
    const int64_t allowed = allowed_megabytes(megabytes);
    if (megabytes <= double(allowed))
        return true;
    error = format("{} would need {:.0f} MB; allowed are {} MB (the least of OpenImageIO's "
                   "limits:imagesize_MB, {} and what control groups allow of it)",
                   what, megabytes, allowed, machine_memory_text);
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

} // namespace ddt
