// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/image.h"

namespace metrics {

/// Peak signal-to-noise ratio in decibels: 10 log10(255^2 / mse), mse over all pixels and the three
/// channels together. Infinite for equal images.
double psnr(const Image& a, const Image& b);

} // namespace metrics
