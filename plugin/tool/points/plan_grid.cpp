// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/plan_grid.h"

#include <algorithm>
#include <cmath>

#include "plugin/image/largest_side.h"
#include "plugin/message/format.h"

namespace ddt::tool {

bool plan_grid(const Window& w, int width, int height, bool y_down, PixelGrid& grid,
               Failure& failure) {
    const double across = w.x1 - w.x0, down = w.y1 - w.y0;
    const double columns = width > 0 ? width : std::max(height * (across / down), 1.0);
    const double rows = height > 0 ? height : std::max(width * (down / across), 1.0);
    if (!(columns <= largest_side && rows <= largest_side)) {
        failure = {format("the image would be {:.0f} x {:.0f} pixels; sides are allowed up to {}: "
                          "give both of --size, or another --window",
                          columns, rows, largest_side),
                   exit_usage};
        return false;
    }
    grid.width = int(std::lround(columns));
    grid.height = int(std::lround(rows));
    grid.step_x = across / grid.width;
    grid.step_y = y_down ? down / grid.height : -down / grid.height;
    grid.x = w.x0 + 0.5 * grid.step_x;
    grid.y = (y_down ? w.y0 : w.y1) + 0.5 * grid.step_y;
    return true;
}

} // namespace ddt::tool
