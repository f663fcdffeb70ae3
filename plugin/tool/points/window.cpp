// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/window.h"

#include <algorithm>

namespace ddt::tool {

Window window_of(const PointMesh& mesh) {
    const auto any = size_t(mesh.triangles.front()[0]);
    Window w{mesh.x[any], mesh.y[any], mesh.x[any], mesh.y[any]};
    for (const auto& triangle : mesh.triangles)
        for (const int32_t corner : triangle) {
            const double x = mesh.x[size_t(corner)], y = mesh.y[size_t(corner)];
            w = {std::min(w.x0, x), std::min(w.y0, y), std::max(w.x1, x), std::max(w.y1, y)};
        }
    return w;
}

} // namespace ddt::tool
