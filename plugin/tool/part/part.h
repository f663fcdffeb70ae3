// SPDX-License-Identifier: Apache-2.0
// Parts of a result, for many machines.
#pragma once

#include <string>

#include "ddt/rect.h"

namespace ddt::tool {

/// The part `index` of `count`, from 1 on.
struct Part {
    int index = 1, count = 1;
};

constexpr int most_parts = 1 << 20;
constexpr const char* allowed_parts = "K/N with whole numbers, 1 <= K <= N <= 1048576";

/// "3/16". False for anything else.
bool parse_part(const std::string& text, Part& part);

/// The share of a part in a grid of columns x rows tiles: not empty, and all of them together are
/// the grid. Whole rows of tiles where there are enough of them. count <= columns * rows.
Rect tiles_of_part(int columns, int rows, Part part);

} // namespace ddt::tool
