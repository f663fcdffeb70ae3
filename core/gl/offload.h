// SPDX-License-Identifier: Apache-2.0
// What the rest of the core knows of GPUs: choosing one for a job and giving it the job's tiles.
// offload_stub.cpp stands in where OpenGL's headers were missing when this was built.
#pragma once

#include <cstddef>
#include <string>

#include "core/tiles/job_state.h"
#include "core/tiles/tiled_job.h"
#include "core/tin/tin.h"
#include "core/triangulate/triangulate.h"
#include "ddt/core.h"

namespace ddt {

namespace gl {
struct Gpu;
}

/// From how many source pixels on, for each of the CPU's threads, a GPU is quicker than these: when
/// it must be opened first, which takes as long as a thread needs for so many, of one job or of all
/// so far; and when it is open already (docs/gpu.md). The help of the option `device` tells them.
constexpr size_t worth_opening = 800'000, worth_using = 20'000;

/// Where a job is worked on.
struct Placement {
    Device device = Device::cpu; ///< never automatic
    gl::Gpu* gpu = nullptr;      ///< null: the CPU
};

/// Choose by Job::device and DDT_DEVICE, and by how many source pixels there are to be worked on
/// for each of the CPU's threads. False if a device that was named cannot be had; `why` says what
/// stood in the way.
bool choose_device(const Job& job, size_t pixels_a_thread, Placement& placement, std::string& why);

/// To be told that the job, for which no GPU was found, is done by the CPU.
void missed_gpu(const Job& job, size_t pixels_a_thread);

/// Work on the tiles of a job as far as the GPU gets; `state` knows how far that is. Adds to
/// `statistics` for the tiles it finished. Returns an empty text, or what the GPU failed at when it
/// did.
std::string work_on_gpu(gl::Gpu& gpu, const TiledJob& job, JobState& state, Statistics& statistics);

/// Flip the edges of a Tin by a scheme that tin_on_gpu(). Adds to `statistics`. Returns an empty
/// text, or what the GPU failed at: then the Tin may be anything.
std::string flip_on_gpu(gl::Gpu& gpu, Tin& tin, const MeshOptions& options,
                        const Workspace& workspace, Statistics& statistics);

/// Whether flip_on_gpu() knows the scheme.
bool tin_on_gpu(const MeshOptions& options);

/// One line about a placement for people: "egl: llvmpipe (...), OpenGL 4.5 ...".
std::string describe(const Placement& placement);

} // namespace ddt
