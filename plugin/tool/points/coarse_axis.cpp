// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/coarse_axis.h"

#include "core/tin/step_grid.h"
#include "plugin/message/format.h"
#include "plugin/tool/points/window.h"

namespace ddt::tool {

std::string note_on_coarse_axis(const PointMesh& mesh) {
    constexpr int64_t few = 1 << 16;
    StepGrid grid;
    std::string ignored; // whoever works on the mesh says it
    if (!grid.fit(mesh, ignored))
        return "";
    const Window w = window_of(mesh);
    const int64_t x = grid.step_x(w.x1) - grid.step_x(w.x0),
                  y = grid.step_y(w.y1) - grid.step_y(w.y0);
    const int64_t fewer = x < y ? x : y;
    if (fewer >= few || fewer == 0) // on one line they are no triangles, which is said, too
        return "";
    return format("x spans {:g} and y {:g}: along {} only {} positions are told apart; have both "
                  "span about as much",
                  w.x1 - w.x0, w.y1 - w.y0, x < y ? "x" : "y", fewer + 1);
}

} // namespace ddt::tool
