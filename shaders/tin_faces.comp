// SPDX-License-Identifier: Apache-2.0
// The faces of all triangles. C++ twin: TinMesh::find_face().
#include "tin.glsl"

void main() {
    int t = own_index();
    if (t < count)
        faces[t] = face_of(triangles[6 * t], triangles[6 * t + 1], triangles[6 * t + 2]);
}
