// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// Mean squared error: the mean of (reference - test)^2 over the pixels, in squared display units
/// (0..255). Gonzalez & Woods, "Digital Image Processing", fidelity criteria. 0 for equal planes.
double mse(const Plane& reference, const Plane& test);

} // namespace metrics
