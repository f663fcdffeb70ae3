// SPDX-License-Identifier: Apache-2.0
// Which lanes of eight come first when those of a mask are put side by side.
#pragma once

#include <cstdint>

namespace ddt {

/// of[mask]: the lanes whose bits are set, in their order, then the others.
struct CompressLanes {
    uint8_t of[256][8] = {};
    constexpr CompressLanes() {
        for (int mask = 0; mask < 256; ++mask) {
            int n = 0;
            for (int bit = 1; bit >= 0; --bit)
                for (int lane = 0; lane < 8; ++lane)
                    if ((mask >> lane & 1) == bit)
                        of[mask][n++] = uint8_t(lane);
        }
    }
};
inline constexpr CompressLanes compress_lanes;

} // namespace ddt
