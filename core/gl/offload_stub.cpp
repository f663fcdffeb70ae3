// SPDX-License-Identifier: Apache-2.0
// Stands in for offload.cpp and work_on_gpu.cpp where OpenGL's headers were missing when this was
// built.
#include "core/gl/offload.h"
#include "core/gl/requested_device.h"

namespace ddt {

bool choose_device(const Job& job, size_t, Placement& placement, std::string& why) {
    placement = {};
    Device wanted;
    if (!gl::requested_device(job, wanted, why))
        return false;
    if (wanted == Device::automatic || wanted == Device::cpu)
        return true;
    why = gl::why_unavailable(wanted, "built without OpenGL's headers");
    return false;
}

void missed_gpu(const Job&, size_t) {}

std::string work_on_gpu(gl::Gpu&, const TiledJob&, JobState&, Statistics&) {
    return "there is no GPU";
}

std::string flip_on_gpu(gl::Gpu&, Tin&, const MeshOptions&, const Workspace&, Statistics&) {
    return "there is no GPU";
}

bool tin_on_gpu(const MeshOptions&) {
    return false;
}

std::string describe(const Placement&) {
    return "cpu";
}

} // namespace ddt
