// SPDX-License-Identifier: Apache-2.0
// A mesh of points that needs no Delaunay triangulation.
#pragma once

#include "ddt/points.h"
#include "tests/core/helpers.h"

namespace ddt::test {

/// A grid whose points are moved about, with two triangles a cell, and values of a slanting step
/// with noise.
inline PointMesh shaken_grid(int width, int height, uint64_t seed, std::vector<float>& guide) {
    Random random(seed);
    PointMesh mesh;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            mesh.x.push_back(x + 0.001 * random.below(400));
            mesh.y.push_back(y + 0.001 * random.below(400));
            guide.push_back((3 * x + 7 * y) % 29 < 13 ? 0.8f : 0.003f * float(random.below(100)));
        }
    for (int32_t y = 0; y + 1 < height; ++y)
        for (int32_t x = 0; x + 1 < width; ++x) {
            const int32_t v = y * width + x;
            mesh.triangles.push_back({v, v + 1, v + width});
            mesh.triangles.push_back({v + 1, v + width + 1, v + width});
        }
    return mesh;
}

} // namespace ddt::test
