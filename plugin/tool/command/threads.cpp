// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/threads.h"

#include <cstdlib>
#include <system_error>

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/sysutil.h>

#include "core/base/parallel.h"
#include "plugin/imagebuf/thread_count.h"

namespace ddt::tool {

Flag threads_flag(int& wanted) {
    return whole_flag("--threads", "N",
                      "threads to use (0, the default: all cores, in a container its quota)", 0,
                      4096, wanted);
}

int planned_threads(int wanted) {
    const int asked = thread_count(wanted);
    allow_threads(asked);
    return threads_for(asked);
}

int share_threads(int wanted) {
    const int asked = thread_count(wanted), threads = planned_threads(wanted);
    // OpenImageIO's pool has one thread less than it is told, and its TIFF writer compresses side
    // by side only where the pool has two.
    try {
        OIIO::attribute("threads", threads == 2 ? 3 : threads);
    } catch (const std::system_error&) {
        // There are no more. A pool that is half made ends the program by a signal, at its end.
        std::_Exit(fail(thrown()));
    }
    const bool quota = asked == 0 && threads < int(OIIO::Sysutil::hardware_concurrency());
    if (wanted > 0 || quota)
        OIIO::attribute("exr_threads", threads == 1 ? -1 : threads); // -1: none of its own
    return threads;
}

} // namespace ddt::tool
