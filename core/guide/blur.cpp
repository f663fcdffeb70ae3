#include "core/guide/blur.h"

#include <algorithm>

#include "core/guide/guide.h"

namespace ddt {

void blur_guide(std::vector<float>& guide, int width, int height, float share) {
    const float own = 1.0f - 2.0f * share;
    const auto mix = [=](float before, float here, float after) {
        return own * here + share * (before + after);
    };
    const auto columns = size_t(width);
    std::vector<float> above(columns), here(columns), below(columns);
    const auto blur_row = [&](int y, std::vector<float>& out) {
        const float* row = guide.data() + size_t(y) * columns;
        for (int x = 0; x < width; ++x)
            out[size_t(x)] = mix(row[std::max(x - 1, 0)], row[x], row[std::min(x + 1, width - 1)]);
    };
    blur_row(0, here);
    above = here;
    for (int y = 0; y < height; ++y) {
        // The row below is still as it was.
        blur_row(std::min(y + 1, height - 1), below);
        if (y == height - 1)
            below = here;
        float* row = guide.data() + size_t(y) * columns;
        for (size_t x = 0; x < columns; ++x)
            row[x] = guide_step(mix(above[x], here[x], below[x]));
        std::swap(above, here);
        std::swap(here, below);
    }
}

} // namespace ddt
