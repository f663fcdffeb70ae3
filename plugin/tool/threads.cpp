// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/threads.h"

#include <OpenImageIO/imageio.h>

#include "core/base/parallel.h"

namespace ddt::tool {

int share_threads(int wanted) {
    allow_threads(wanted);
    int threads = wanted;
    if (wanted <= 0)
        OIIO::getattribute("threads", threads);
    threads = threads > 0 ? allowed_threads(threads) : usual_threads();
    // OpenImageIO's pool has one thread less than it is told, and its TIFF writer compresses side
    // by side only where the pool has two.
    OIIO::attribute("threads", threads == 2 ? 3 : threads);
    if (wanted > 0)
        OIIO::attribute("exr_threads", threads == 1 ? -1 : threads); // -1: none of its own
    return threads;
}

} // namespace ddt::tool
