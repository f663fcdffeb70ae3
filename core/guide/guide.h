// SPDX-License-Identifier: Apache-2.0
// The arithmetic of the guide beside ddt/guide.h.
#pragma once

#include "ddt/guide.h"

namespace ddt {

/// The sRGB encoding curve (IEC 61966-2-1) of linear light, extended oddly below 0 and past 1.
/// For any finite `light`: within 2^-16 * max(1, curve) of the exact curve, and
/// guide_step(srgb_curve(light)) never falls as `light` grows.
float srgb_curve(float light);

/// The multiple of 2^-12 nearest to v, within -1024 to 1024; 0 for NaN and infinities.
float guide_step(float v);

/// Mix every number of a width x height guide with its neighbours': `share` (0 to largest_blur) of
/// each on the left and right, then of each above and below; at the rim the outermost repeat. The
/// results are multiples of 2^-12 again; what a non-finite number touches is 0.
///
/// A little of it takes single pixels' noise out of the choice of edges and moves no edge.
void blur_guide(float* guide, int width, int height, float share);

} // namespace ddt
