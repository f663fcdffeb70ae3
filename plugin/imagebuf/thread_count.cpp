// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/thread_count.h"

#include <algorithm>

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/sysutil.h>

namespace ddt {

int thread_count(int nthreads) {
    if (nthreads > 0)
        return nthreads;
    OIIO::getattribute("threads", nthreads);
    // As it comes it counts processors that a container's quota leaves no time on.
    const bool all = nthreads == int(OIIO::Sysutil::hardware_concurrency());
    return all ? 0 : std::max(nthreads, 0);
}

} // namespace ddt
