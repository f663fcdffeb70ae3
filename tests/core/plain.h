// SPDX-License-Identifier: Apache-2.0
// Options without what filters add, for tests that count on one thing at a time: the guide as it
// is, no contours, flips down to the cost's own threshold, no soft edges.
#pragma once

#include "ddt/core.h"

namespace ddt::test {

inline MeshOptions plain_mesh() {
    MeshOptions mesh;
    mesh.blur = 0;
    mesh.contour = 0;
    mesh.min_gain = -1;
    return mesh;
}

inline Job plain_job() {
    Job job;
    job.mesh = plain_mesh();
    job.surface = Surface::patch;
    return job;
}

} // namespace ddt::test
