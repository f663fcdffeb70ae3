// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// Signal-to-noise ratio in decibels: 10 log10(sum of reference^2 / sum of (reference - test)^2).
/// Gonzalez & Woods, "Digital Image Processing", fidelity criteria. Infinite for equal planes,
/// -infinite for a black reference and another plane.
double snr(const Plane& reference, const Plane& test);

} // namespace metrics
