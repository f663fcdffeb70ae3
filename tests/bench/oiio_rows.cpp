// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imagebufalgo.h>

#include "rows.h"

namespace bench {

std::vector<Row> oiio_rows() {
    std::vector<Row> rows;
    for (const char* filter : {"triangle", "blackman-harris", "catmull-rom", "lanczos3"})
        rows.push_back({filter, [filter](const OIIO::ImageBuf& image, int scale) {
                            OIIO::ROI roi(0, image.spec().width * scale, 0,
                                          image.spec().height * scale, 0, 1, 0, 3);
                            return OIIO::ImageBufAlgo::resize(image, filter, 0, roi);
                        }});
    return rows;
}

} // namespace bench
