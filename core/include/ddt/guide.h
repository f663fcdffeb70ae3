// SPDX-License-Identifier: Apache-2.0
// The guide: the one number per pixel in which edges are sought. Sources give it with their pixels.
//
// It is the picture's luminance, through the sRGB curve where the picture is in linear light, less
// half of what alpha lacks to 1, so that outlines of what is covered show whatever its colour; a
// multiple of 2^-12, so that differences of it are exact. The arithmetic is float32 + - * in one
// written order and integer steps on exponents: every machine finds the same bits, which no libm's
// pow promises.
#pragma once

#include <cstddef>

namespace ddt {

/// Shares of red, green and blue in the luminance, of Rec. 709 primaries.
constexpr float luminance_weights[3] = {0.2126f, 0.7152f, 0.0722f};

/// Which numbers of a pixel make the guide, and how.
struct GuideRecipe {
    /// Positions in the pixel of up to three channels, below make_guide()'s `stride`; -1 for none.
    /// All none: the guide is 0.
    int channel[3] = {-1, -1, -1};
    /// Their shares in the luminance.
    float weight[3] = {0, 0, 0};
    /// Position, likewise, of the alpha that the channels are associated (premultiplied) with; or
    /// -1.
    int alpha = -1;
    /// True for linear light: the guide is taken through the sRGB curve. False: the numbers are
    /// display-encoded and serve as they are.
    bool linear = true;
};

/// The guide of `count` pixels of `stride` floats each: from -1024.5 to 1024. A luminance that is
/// not finite counts as 0, such an alpha as 1. Safe to call from several threads at once.
void make_guide(const GuideRecipe& recipe, const float* pixels, size_t count, int stride,
                float* guide) noexcept;

} // namespace ddt
