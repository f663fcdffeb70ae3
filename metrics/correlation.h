// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// Correlation coefficient (Pearson 1895): covariance over the product of standard deviations, -1
/// to 1; the same after any change of brightness or contrast. Where a plane is flat: 1 if both are,
/// else 0.
double correlation(const Plane& a, const Plane& b);

/// Normalized cross-correlation (Eskicioglu & Fisher 1995, "Image quality measures and their
/// performance", IEEE Transactions on Communications 43(12)): sum of reference * test over sum of
/// reference^2. 1 for equal planes; means are not taken off, so unlike correlation() it tells a
/// test that is too bright (above 1) or too dark. 1 for a black reference.
double cross_correlation(const Plane& reference, const Plane& test);

} // namespace metrics
