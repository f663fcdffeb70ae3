// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// Gradient magnitude similarity deviation; 0 for equal planes, larger is worse. After Xue, Zhang,
/// Mou, Bovik, "Gradient magnitude similarity deviation", IEEE Transactions on Image Processing
/// 23(2), 2014: 2x2 means, Prewitt gradients, c = 170. Pixels without all eight neighbours are left
/// out.
double gmsd(const Plane& a, const Plane& b);

} // namespace metrics
