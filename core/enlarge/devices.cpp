// SPDX-License-Identifier: Apache-2.0
#include "ddt/devices.h"

#include "core/base/guarded.h"
#include "core/enlarge/thread_count.h"
#include "core/gl/offload.h"
#include "core/gl/requested_device.h"
#include "ddt/option_table.h"

namespace ddt {

bool describe_device(const Job& job, std::string& line) noexcept {
    std::string text;
    const bool had = succeeds(&line, [&](std::string& why) {
        Placement placement;
        const FilterOptions usual;
        if (!check_options({usual.surface, job.mesh, usual.light, job.device, usual.holes}, why))
            return false;
        if (!choose_device(job, pixels_a_thread(job.window.area(), job), placement, why))
            return false;
        text = describe(placement);
        return true;
    });
    if (had)
        line.swap(text);
    return had;
}

bool check_device(Device device, std::string& line) noexcept {
    std::string error;
    const bool may = succeeds(&error, [&](std::string& why) {
        Job job;
        job.device = device;
        return gl::requested_device(job, device, why);
    });
    if (!may)
        line.swap(error);
    return may;
}

} // namespace ddt
