// SPDX-License-Identifier: Apache-2.0
// The guide: the one number a pixel in which edges are sought.
//
// It is the luminance of the picture over mid-grey, through the sRGB curve where the picture is in
// linear light, and a multiple of 2^-12, so that differences of it are exact. The arithmetic is
// float32 + - * in one written order and integer steps on exponents: every machine finds the same
// bits, which no libm's pow promises.
#pragma once

#include <cstddef>
#include <vector>

namespace ddt {

/// Which numbers of a pixel make the guide, and how.
struct GuideRecipe {
    /// Positions in the pixel of up to three channels; -1 for none. All none: the guide is 0.
    int channel[3] = {-1, -1, -1};
    /// Their shares in the luminance.
    float weight[3] = {0, 0, 0};
    /// Position of the alpha that the channels are associated (premultiplied) with, or -1.
    int alpha = -1;
    /// True for linear light: the guide is taken through srgb_curve(). False: the numbers are
    /// display-encoded and serve as they are.
    bool linear = true;
};

/// The sRGB encoding curve (IEC 61966-2-1) of linear light, extended oddly below 0 and past 1.
/// For any finite `light`: within 2^-16 * max(1, curve) of the exact curve, and
/// guide_step(srgb_curve(light)) never falls as `light` grows.
float srgb_curve(float light);

/// The multiple of 2^-12 nearest to v, within -1024 to 1024; 0 for NaN and infinities.
float guide_step(float v);

/// The guide of `count` pixels of `stride` floats each.
void make_guide(const GuideRecipe& recipe, const float* pixels, size_t count, int stride,
                float* guide);

/// Mix every number of a width x height guide with its neighbours': `share` (0 to 1/4) of each on
/// the left and right, then of each above and below; at the rim the outermost repeat. The results
/// are multiples of 2^-12 again; what a non-finite number touches is 0.
///
/// A little of it takes single pixels' noise out of the choice of edges and moves no edge.
void blur_guide(std::vector<float>& guide, int width, int height, float share);

} // namespace ddt
