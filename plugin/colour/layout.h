// SPDX-License-Identifier: Apache-2.0
// Where a pixel's colour is.
#pragma once

namespace ddt {

/// Where a pixel's colour is: positions among its interleaved channels.
struct ColourLayout {
    int count = 0; ///< 3: red, green, blue; 1: grey; 0: none
    int channel[3] = {-1, -1, -1};
    int alpha = -1; ///< the alpha it is associated with, or -1
};

} // namespace ddt
