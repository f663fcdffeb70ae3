// SPDX-License-Identifier: Apache-2.0
// The stages of a tile on the CPU, in the order of a device's sites and pixels.
#pragma once

#include <vector>

#include "core/lattice/lattice.h"
#include "ddt/core.h"

namespace ddt::test {

/// A mesh: a site each.
struct MeshStage {
    std::vector<uint64_t> sites; ///< vectors_of() edges
    std::vector<float> gains;
    int stride = 0;
};

/// What the surface is made for: corrections' strength is no power of two then, by which a product
/// is the same however it is rounded.
constexpr Mapping::Scale surface_scale{1.9, 1.95};

/// The first group of channels of the surface over it.
struct SurfaceStage {
    std::vector<float> vertices;  ///< group_size a pixel
    std::vector<float> gradients; ///< 2 group_size a pixel, x then y; empty: there are none
    std::vector<float> bends;     ///< group_size a site; empty: there are none
    std::vector<float> softness;  ///< group_size a site; empty: there is none
};

/// The mesh of the guide by these options, but after so many iterations at most.
MeshStage cpu_mesh(const std::vector<float>& guide, int width, int height,
                   const MeshOptions& options, int iterations);

/// The surface over the finished mesh after so many rounds of corrections.
SurfaceStage cpu_surface(const std::vector<float>& guide, const std::vector<float>& values,
                         int width, int height, const Job& job, int rounds);

} // namespace ddt::test
