// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/fit_format.h"

#include <algorithm>

namespace ddt::tool {

bool fit_format(const OIIO::ImageOutput& output, const std::string& path, OIIO::ImageSpec& spec,
                Failure& failure) {
    if (!output.supports("channelformats"))
        spec.channelformats.clear();
    OIIO::ROI roi = spec.roi();
    if (!output.supports("displaywindow"))
        roi = spec.roi_full();
    if (!output.supports("negativeorigin")) {
        roi.xbegin = std::max(roi.xbegin, 0);
        roi.ybegin = std::max(roi.ybegin, 0);
    }
    if (roi.width() < 1 || roi.height() < 1) {
        failure = {"cannot write \"" + path + "\": no pixel has coordinates of 0 and more, and " +
                   output.format_name() + " holds no others"};
        return false;
    }
    spec.x = roi.xbegin;
    spec.y = roi.ybegin;
    spec.width = roi.width();
    spec.height = roi.height();
    return true;
}

} // namespace ddt::tool
