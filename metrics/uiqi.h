// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// Universal image quality index (Wang & Bovik 2002, "A universal image quality index", IEEE Signal
/// Processing Letters 9(3)): the mean over all windows of 8 x 8 pixels of
///     4 cov(a, b) mean(a) mean(b) / ((var(a) + var(b)) (mean(a)^2 + mean(b)^2)),
/// -1 to 1, 1 for equal planes. In windows where both planes are flat the ratio of means alone
/// counts: 2 mean(a) mean(b) / (mean(a)^2 + mean(b)^2); where both are black, 1. A plane smaller
/// than the window is one window.
double uiqi(const Plane& a, const Plane& b);

} // namespace metrics
