// SPDX-License-Identifier: Apache-2.0
// Points to triangulate.
#pragma once

#include <cstdint>

#include "ddt/points.h"
#include "tests/core/random.h"

namespace ddt::test {

/// `count` points in a square of 1000 x 1000.
inline PointMesh random_points(int count, uint64_t seed) {
    Random random(seed);
    PointMesh mesh;
    for (int i = 0; i < count; ++i) {
        mesh.x.push_back(random.below(1000000) * 1e-3);
        mesh.y.push_back(random.below(1000000) * 1e-3);
    }
    return mesh;
}

} // namespace ddt::test
