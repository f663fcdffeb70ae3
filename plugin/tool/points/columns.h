// SPDX-License-Identifier: Apache-2.0
// What points have beside their positions.
#pragma once

#include <string>
#include <vector>

namespace ddt::tool {

struct PointFile;

/// Numbers of points beside their x and y. `scale` is what a whole unit is in the file: 255 and
/// 65535 for colours that are bytes and words, else 1; values are divided by it.
struct Column {
    std::string name, type; ///< as PLY calls them: "red", "uchar"
    double scale = 1;
    std::vector<double> values; ///< which hold every type's numbers

    bool is_colour() const { return name == "red" || name == "green" || name == "blue"; }
    bool is_alpha() const { return name == "alpha"; }
};

/// Columns that are colour and its alpha, and their letters: an image's channels, and what a text
/// may call them.
inline constexpr const char* colour_columns[][2] = {
    {"red", "R"}, {"green", "G"}, {"blue", "B"}, {"alpha", "A"}};

std::vector<const Column*> all_columns(const PointFile& points);

/// The columns a command works on when nothing names them: red, green and blue, and alpha if it is
/// there; else z; else all.
std::vector<const Column*> usual_columns(const PointFile& points);

/// The sum of the columns that are not alpha, of more than three each as a share of its range, from
/// 0 at the least to 1 at the largest: what edges are sought in. Points with a NaN in one of the
/// columns have none.
std::vector<float> guide_of(const PointFile& points, const std::vector<const Column*>& columns);

} // namespace ddt::tool
