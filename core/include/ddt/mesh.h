// SPDX-License-Identifier: Apache-2.0
// The mesh itself, for programs that want triangles instead of a larger picture.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ddt/core.h"

namespace ddt {

/// A triangulation of an image: vertex y * width + x is pixel (x, y), at (x, y).
struct Mesh {
    int width = 0, height = 0;
    /// Vertices of each triangle; every triangle has area 1/2 and runs the same way round: from x
    /// towards y. There are 2 (width - 1) (height - 1). Their order is that of their first edge's
    /// midpoint, row by row.
    std::vector<std::array<int32_t, 3>> triangles;
};

/// What became of the cost.
struct MeshReport {
    double cost_start = 0; ///< of the starting mesh: the sum over its edges
    double cost = 0;       ///< of the mesh
    Statistics statistics;
};

/// Triangulate a whole image at once, to one mesh whatever MeshOptions::meshes is. (enlarge() does
/// it tile by tile: of photographs the same mesh but for edges, less than one in a million, that
/// depend on something more than a halo away. Along straight hard edges of slopes 2:1, 3:1 many
/// do.) Takes about 80 bytes per pixel meanwhile. `guide`: width x height floats, row by row, about
/// 0 to 1; what is below 2^-24 or not finite counts as 0. `progress` is told rough shares. False if
/// `guide` is null, the image has less than 2 x 2 pixels or more than 2^28, an option is not
/// allowed, memory runs out, or it was cancelled; `mesh` and `report` are then as they were.
/// `error` is that of ddt/core.h.
bool build_mesh(const float* guide, int width, int height, const MeshOptions& options, Mesh& mesh,
                MeshReport* report = nullptr, std::string* error = nullptr,
                const ProgressCallback& progress = {}) noexcept;

} // namespace ddt
