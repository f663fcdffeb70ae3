// SPDX-License-Identifier: Apache-2.0
#include "core/gl/gpu.h"

#include <mutex>

#include <pthread.h>
#include <unistd.h>

#include "core/base/stopwatch.h"
#include "core/gl/context/faults.h"
#include "core/gl/context/hardware.h"

namespace ddt::gl {

namespace {

/// A device that was looked for, and what came of it.
struct Slot {
    std::once_flag once;
    Gpu* gpu = nullptr;
    std::string why;
    std::atomic<bool> tried{false};
};

struct Registry {
    Slot hardware, egl, osmesa;
    std::atomic<size_t> missed{0};
    std::atomic<pid_t> missed_by{0}; ///< the process that counted them
    std::atomic<pid_t> told{0};      ///< the process that was told why it has none
};

/// Made on first use, since a static object may enlarge before those of this file are made; never
/// destroyed, so that it outlives every thread and static object.
std::atomic<Registry*>& registry_in_use() {
    static std::atomic<Registry*> made{new Registry};
    return made;
}
std::atomic<bool> g_started{false}; ///< this process or one it was forked from has had a GL thread
std::atomic<bool> g_forked{false};
#ifdef DDT_FAULTS
std::string& device_files() {
    static auto* made = new std::string("/dev");
    return *made;
}
#else
constexpr const char* device_files() {
    return "/dev";
}
#endif

std::unique_ptr<Context> make_context(Device device, std::string& why) {
    switch (device) {
    case Device::osmesa:
        return make_osmesa_context(why);
    case Device::egl:
        return make_egl_context(Wanted::any, why);
    default:
        return make_egl_context(Wanted::hardware, why);
    }
}

/// Set up the device whose context was made.
void prepare(Gpu& gpu) {
    const Functions& gl = gpu.context->gl;
    GLint64 limit = 0;
    gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
    gpu.block_limit = size_t(limit);
    gpu.programs = std::make_unique<Programs>(gl);
}

void start(Device device, Slot& slot) {
    static std::once_flag once;
    std::call_once(once, [] {
        pthread_atfork(nullptr, nullptr, [] {
            if (g_started)
                g_forked = true;
        });
    });
    g_started = true;
    const Stopwatch watch;
    auto* gpu = new Gpu;
    gpu->thread
        .post([&] {
            gpu->context = make_context(device, slot.why);
            if (gpu->context)
                prepare(*gpu);
        })
        .get();
    gpu->open_milliseconds = watch.milliseconds();
    if (gpu->context)
        slot.gpu = gpu; // else its idle thread is left behind
}

/// start(), whatever happens: a machine without a thread to spare has no device.
void try_to_start(Device device, Slot& slot) {
    try {
        if (device == Device::automatic && !hardware_possible(device_files()))
            slot.why = std::string("no GPU's driver has files in ") + device_files();
        else
            start(device, slot);
    } catch (const std::exception& e) {
        slot.why = e.what();
    }
    slot.tried = true;
}

Gpu* working(const Slot& slot, std::string& why) {
    why = slot.why;
    if (!slot.gpu || !slot.gpu->broken)
        return slot.gpu;
    why = "the context was lost in an earlier job";
    return nullptr;
}

} // namespace

Gpu* open(Device device, std::string& why, bool& forked) {
    forked = g_forked;
    if (forked) {
        why = "OpenGL does not survive fork()";
        return nullptr;
    }
    Registry& registry = *registry_in_use();
    const auto slot_of = [&](Device kind, Slot& slot) -> Slot& {
        std::call_once(slot.once, [&] { try_to_start(kind, slot); });
        return slot;
    };
    Slot& slot = device == Device::osmesa ? slot_of(device, registry.osmesa)
                                          : slot_of(Device::automatic, registry.hardware);
    if (device == Device::egl && !slot.gpu) {
        Slot& any = slot_of(device, registry.egl);
        return working(any, why);
    }
    return working(slot, why);
}

bool is_open(Device device) {
    const Registry& registry = *registry_in_use();
    return device == Device::osmesa ? registry.osmesa.tried : registry.hardware.tried;
}

std::atomic<size_t>& missed_pixels() {
    Registry& registry = *registry_in_use();
    // A forked child begins anew.
    if (const pid_t self = getpid(); registry.missed_by.exchange(self) != self)
        registry.missed = 0;
    return registry.missed;
}

bool first_told_of_cpu() {
    const pid_t self = getpid();
    return registry_in_use().load()->told.exchange(self) != self;
}

#ifdef DDT_FAULTS
void look_for_hardware_in(const std::string& folder) {
    device_files() = folder;
}

void forget_devices() {
    registry_in_use() = new Registry;
}
#endif

} // namespace ddt::gl
