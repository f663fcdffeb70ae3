// SPDX-License-Identifier: Apache-2.0
// The same on a device. All are for its thread and throw gl::Failure.
#pragma once

#include "core/gl/host_tile.h"
#include "tests/core/gl/stages/cpu_stages.h"

namespace ddt::test {

/// A tile on a device.
class GpuStages {
public:
    GpuStages(gl::Gpu& gpu, Source& source, const Job& job);

    /// The mesh after so many iterations at most. `gains_alone`: gains as they are found of a mesh
    /// that came from elsewhere, not as they were kept.
    MeshStage mesh(const MeshOptions& options, int iterations, bool gains_alone);
    /// The surface over the finished mesh.
    SurfaceStage surface(int rounds);
    /// The result: of out_width x out_height pixels.
    std::vector<float> result(int out_width, int out_height);

private:
    void write_guide();
    void finish_mesh();

    gl::Gpu& m_gpu;
    Job m_job;
    gl::SlotShape m_shape;
    gl::Numbers m_numbers;
    gl::HostTile m_tile;
    gl::DeviceMesh m_mesh;
};

} // namespace ddt::test
