// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// How far an enlarged image leaves what its source has nearby.
struct Overshoot {
    double largest = 0;
    double mean = 0;           ///< over all pixels and channels
    double negative_share = 0; ///< share of values below 0, 0..1
};

/// `enlarged` is `scale` times as wide and high as `source`, neither clipped nor rounded. The range
/// nearby is that of the source pixels at most `reach` columns and rows from the one the output
/// pixel's centre lies in.
Overshoot overshoot(const Image& source, const Image& enlarged, int scale, int reach = 1);

} // namespace metrics
