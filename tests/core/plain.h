// SPDX-License-Identifier: Apache-2.0
// Options without what filters add, for tests that count on one thing at a time: the guide as it
// is, no contours, flips down to the cost's own threshold, no soft edges, the CPU: a GPU would be
// looked for by how much a process has done.
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

/// One without corrections and soft edges.
inline SurfaceOptions plain_surface(Surface kind = Surface::patch) {
    SurfaceOptions surface;
    surface.kind = kind;
    surface.soft = 0;
    return surface;
}

inline Job plain_job() {
    Job job;
    job.mesh = plain_mesh();
    job.surface = plain_surface();
    job.device = Device::cpu;
    return job;
}

} // namespace ddt::test
