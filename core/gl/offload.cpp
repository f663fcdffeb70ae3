// SPDX-License-Identifier: Apache-2.0
#include "core/gl/offload.h"

#include "core/base/log.h"
#include "core/gl/device_mesh.h"
#include "core/gl/gpu.h"
#include "core/gl/requested_device.h"
#include "ddt/names.h"

namespace ddt {

namespace {

/// Whether one that is open would be quicker.
bool gains(const Job& job, size_t pixels_a_thread) {
    return gl::DeviceMesh::knows(job.mesh) && pixels_a_thread >= worth_using;
}

bool worth_a_gpu(const Job& job, size_t pixels_a_thread) {
    return gains(job, pixels_a_thread) && (gl::is_open(Device::automatic) ||
                                           gl::missed_pixels() + pixels_a_thread >= worth_opening);
}

} // namespace

bool choose_device(const Job& job, size_t pixels_a_thread, Placement& placement, std::string& why) {
    placement = {};
    Device wanted;
    if (!gl::requested_device(job, wanted, why))
        return false;
    if (wanted == Device::cpu)
        return true;
    const bool named = wanted != Device::automatic;
    if (!named && !worth_a_gpu(job, pixels_a_thread))
        return true;
    bool forked = false;
    std::string reason;
    placement.gpu = gl::open(wanted, reason, forked);
    if (placement.gpu) {
        placement.device = named ? wanted : Device::egl;
        return true;
    }
    if (!named || forked) {
        if (verbose() && gl::first_told_of_cpu())
            say("ddt: no GPU is used: %s", reason.c_str());
        return true;
    }
    why = gl::why_unavailable(wanted, reason);
    return false;
}

void missed_gpu(const Job& job, size_t pixels_a_thread) {
    if (job.device == Device::automatic && gains(job, pixels_a_thread))
        gl::missed_pixels() += pixels_a_thread;
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
