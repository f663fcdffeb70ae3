// SPDX-License-Identifier: Apache-2.0
// Bytes that the kernels need, counted from the sizes of their lists.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/gl/device_mesh.h"
#include "core/gl/surfaces.h"

namespace ddt::bench {

/// What was worked on; sums over all tiles.
struct Workload {
    double pixels = 0; ///< of tiles with their halos
    double served = 0; ///< of tiles alone
    double out = 0;    ///< positions sampled
    /// Pixels at which gradients were made, the net's edges, and corrections, in all rounds; of the
    /// last the rounds that read the source beside corrected values; pixels whose edges' fitted
    /// bends were made.
    double gradients = 0, edges = 0, corrections = 0, later_corrections = 0, bends = 0;
    std::vector<gl::IterationCounts> iterations;
    /// Times that the group of finish.comp goes over its lists for the tile with most of them: each
    /// waits for what it reads, as a dispatch does.
    int passes = 0;
};

/// Such passes of one tile, whose iterations from the first on these are, in place 1.
int finish_passes(const std::vector<gl::IterationCounts>& tile);

/// Add what the tile with its pixels, positions and reach needs, iterations aside.
void add_tile(const gl::TileSize& tile, double positions, const gl::Reach& reach,
              const SurfaceOptions& surface, Workload& work);

/// Bytes by kernel. A dispatch reads and writes each number once, however many invocations want it:
/// neighbours want it at about the same time, and it is in a cache then. Four channels are
/// written a position. Of the schemes only what one-round dispatches is counted.
std::map<std::string, double> traffic(const Workload& work, const MeshOptions& mesh,
                                      const SurfaceOptions& surface);

} // namespace ddt::bench
