// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/cuts.h"

#include <algorithm>
#include <cmath>

#include "core/tiles/grid.h"

namespace ddt {

std::vector<int> cuts_between_tiles(const ResizeMapping::Axis& a, int least, int most) {
    const double scale = double(a.to_size) / a.from_size;
    const double step = tile_size * std::max(1.0, std::ceil(least / (tile_size * scale)));
    std::vector<int> cuts{a.out0};
    for (int64_t k = 1; cuts.back() < a.out1; ++k) {
        const int64_t border = a.window0 + int64_t(step) * k;
        // The hull of the pixels' centres goes on to the edge.
        const int begin = cuts.back();
        const int stop = border >= a.window1 - 1 ? a.out1 : a.first_at_or_after(int(border));
        const int parts = stop > begin ? std::max(1, (stop - begin + most * 3 / 4) / most) : 0;
        for (int i = 1; i <= parts; ++i)
            cuts.push_back(begin + int(int64_t(stop - begin) * i / parts));
    }
    return cuts;
}

size_t piece_of(const std::vector<int>& cuts, int i) {
    return size_t(std::upper_bound(cuts.begin(), cuts.end(), i) - cuts.begin()) - 1;
}

} // namespace ddt
