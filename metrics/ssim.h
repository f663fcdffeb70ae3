// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// Structural similarity, mean over the plane; 1 for equal planes. After Wang, Bovik, Sheikh,
/// Simoncelli, "Image quality assessment: from error visibility to structural similarity", IEEE
/// Transactions on Image Processing 13(4), 2004: Gaussian window 11x11 with sigma 1.5, K1 = 0.01,
/// K2 = 0.03, L = 255, windows wholly inside the plane, no reduction beforehand. The
/// window is as small as the plane's shorter side where that is less than 11.
double ssim(const Plane& a, const Plane& b);

/// The same over five scales. After Wang, Simoncelli, Bovik, "Multi-scale structural similarity for
/// image quality assessment", Asilomar 2003, with its weights and 2x2 means between the scales. A
/// plane too small for five scales gets as many as fit, at least one, their weights scaled to the
/// sum of 1.
double ms_ssim(const Plane& a, const Plane& b);

} // namespace metrics
