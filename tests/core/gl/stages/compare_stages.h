// SPDX-License-Identifier: Apache-2.0
// One tile worked on by the CPU and by a device, compared after every stage.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/gl/gpu.h"
#include "tests/core/gl/enlarge_pair.h"

namespace ddt::test {

/// What came of a stage.
struct StageResult {
    std::string name; ///< "mesh after iteration 3"
    std::string what; ///< "edges": what was compared
    size_t compared = 0, differing = 0;
    /// The first that differs, in the order of rows: of a mesh's sites at its place in the doubled
    /// lattice, of the result in the output's pixels; its channel; its bits, of an edge the first
    /// four bytes of its record that differ.
    int x = 0, y = 0, channel = 0;
    uint32_t cpu = 0, gpu = 0;
};

/// The stages of the job on the picture, all of it a single tile, enlarged twofold: the starting
/// mesh and its gains, mesh and gains after each iteration (of schemes that the device knows),
/// gradients, bends and softness of edges, vertices after each round of corrections, results. Each
/// device goes on with what it made itself, so that what differs first is where to look.
///
/// The picture: at most tile_size pixels wide and high; at least 2. Of the job channels' kinds,
/// mesh and surface count, of several meshes the first. Posts to the device's thread.
std::vector<StageResult> compare_stages(gl::Gpu& gpu, const Picture& picture, const Job& job);

/// A line about a stage.
std::string line_of(const StageResult& stage);

} // namespace ddt::test
