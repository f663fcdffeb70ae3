// SPDX-License-Identifier: Apache-2.0
// How far a file is of an image's vertices, row by row, and the triangles after them.
#pragma once

#include "ddt/mesh.h"
#include "ddt/progress.h"

namespace ddt::tool {

/// Either takes about half of the time. False to stop.
inline bool tell_row(const Mesh& mesh, int row, const ProgressCallback& progress) {
    return progress(0.5f * float(row) / float(mesh.height));
}

/// Triangles from one telling to the next: so many that it takes no time.
constexpr size_t triangles_told = 1 << 16;

inline bool tell_triangle(const Mesh& mesh, size_t done, const ProgressCallback& progress) {
    return done % triangles_told != 0 ||
           progress(0.5f + 0.5f * float(done) / float(mesh.triangles.size()));
}

} // namespace ddt::tool
