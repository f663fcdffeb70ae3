// SPDX-License-Identifier: Apache-2.0
// Guides of several kinds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/core/random.h"

namespace ddt::test {

/// Kinds of guide. `few` has three levels only, so gains tie all over.
enum class Kind { noise, few, flat, shapes };
inline constexpr Kind all_kinds[] = {Kind::noise, Kind::few, Kind::flat, Kind::shapes};

/// A guide, multiples of 2^-12 about in [0, 1]. `shapes` are half planes, discs and slopes with a
/// little noise, something like a photograph. Integer arithmetic only: the same everywhere.
inline std::vector<float> make_guide(Kind kind, int width, int height, uint64_t seed) {
    Random random(seed);
    struct Shape {
        int x, y, nx, ny, radius, level;
    };
    std::vector<Shape> shapes(size_t(3 + width * height / 400));
    for (Shape& s : shapes)
        s = {random.below(width),   random.below(height),  random.between(-9, 9),
             random.between(-9, 9), random.between(1, 12), random.below(4000)};
    std::vector<float> guide;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int level = 0;
            switch (kind) {
            case Kind::noise:
                level = random.below(4097);
                break;
            case Kind::few:
                level = 2048 * random.below(3);
                break;
            case Kind::flat:
                level = 1234;
                break;
            case Kind::shapes:
                level = (7 * x + 3 * y) % 3000;
                for (const Shape& s : shapes) {
                    const int dx = x - s.x, dy = y - s.y;
                    if (dx * dx + dy * dy < s.radius * s.radius && dx * s.nx + dy * s.ny > -20)
                        level = s.level + 5 * dx;
                }
                level += random.below(40);
                break;
            }
            guide.push_back(float(level) * (1.0f / 4096.0f));
        }
    return guide;
}

} // namespace ddt::test
