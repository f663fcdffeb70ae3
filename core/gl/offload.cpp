// SPDX-License-Identifier: Apache-2.0
#include "core/gl/offload.h"
#include "ddt/names.h"

#include "core/gl/choice.h"
#include "core/gl/context/gpu.h"
#include "core/gl/device_mesh.h"

namespace ddt {

bool find_place(const Job& job, int threads, Placement& placement, std::string& why) {
    placement = {};
    Device wanted;
    if (!gl::wish(job, wanted, why))
        return false;
    if (wanted == Device::cpu)
        return true;
    const bool named = wanted != Device::automatic;
    if (!named &&
        (!gl::DeviceMesh::knows(job.mesh) ||
         job.window.area() / size_t(threads) < (gl::is_open(wanted) ? worth_using : worth_opening)))
        return true;
    bool forked = false;
    std::string reason;
    placement.gpu = gl::open(wanted, reason, forked);
    if (placement.gpu) {
        placement.device = named ? wanted : Device::egl;
        return true;
    }
    if (!named || forked)
        return true;
    why = std::string("ddt: device ") + device_name(wanted) + " is unavailable: " + reason;
    return false;
}

bool tin_on_gpu(const MeshOptions& options) {
    return gl::DeviceMesh::knows(options);
}

std::string describe(const Placement& placement) {
    if (!placement.gpu)
        return "cpu";
    const gl::Context& context = *placement.gpu->context;
    return std::string(device_name(placement.device)) + ": " + context.renderer + ", OpenGL " +
           context.version + ", by " + context.platform;
}

} // namespace ddt
