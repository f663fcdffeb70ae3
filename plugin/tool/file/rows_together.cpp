// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/rows_together.h"

#include <algorithm>

namespace ddt::tool {

int rows_in_strip(const OIIO::ImageSpec& spec) {
    return std::clamp(spec.get_int_attribute("tiff:RowsPerStrip", 1), 1, 1 << 20);
}

} // namespace ddt::tool
