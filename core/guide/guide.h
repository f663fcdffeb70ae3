// SPDX-License-Identifier: Apache-2.0
// The arithmetic of the guide beside ddt/guide.h.
#pragma once

#include <cstddef>

#include "ddt/guide.h"

namespace ddt {

/// The sRGB encoding curve (IEC 61966-2-1) of linear light, extended oddly below 0 and past 1.
/// For any finite `light`: within 2^-16 * max(1, curve) of the exact curve, and
/// guide_step(srgb_curve(light)) never falls as `light` grows.
float srgb_curve(float light);

/// The multiple of guide_unit nearest to v, within -guide_limit to guide_limit; 0 for NaN and
/// infinities.
float guide_step(float v);

/// Numbers of a guide nearer to zero than this count as zero: see least_value
/// (core/tiles/tile_io.h).
constexpr float least_guide = 0x1p-24f;

/// Make what every guide must be of n of its numbers, a lattice's or points': those nearer to zero
/// than least_guide become zero, and so do those that are not finite. Shaders branch by what is
/// computed from them, and need not compare NaN as the CPU does.
void clean_guide(float* guide, size_t n);

/// Mix every number of a width x height guide with its neighbours': `share` (0 to largest_blur) of
/// each on the left and right, then of each above and below; at the rim the outermost repeat. The
/// results are multiples of guide_unit again; what a non-finite number touches is 0.
///
/// A little of it takes single pixels' noise out of the choice of edges and moves no edge.
void blur_guide(float* guide, int width, int height, float share);

} // namespace ddt
