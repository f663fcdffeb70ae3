// SPDX-License-Identifier: Apache-2.0
#include "core/guide/guide.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/arith.h"
#include "core/base/constants.h"
#include "core/base/float_bits.h"
#include "core/base/float_mode.h"
#include "core/base/zero_small.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/guide/guide.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {

#include "core/guide/guide-inl.h"

/// Luminance of n pixels that begin with red, green and blue: loads a compiler makes vectors of.
template <size_t stride>
HWY_INLINE void luminance_of_first(const float (&weight)[3], const float* pixels, size_t n,
                                   float* y) {
    for (size_t i = 0; i < n; ++i) {
        const float* pixel = pixels + i * stride;
        y[i] = ((0.0f + weight[0] * pixel[0]) + weight[1] * pixel[1]) + weight[2] * pixel[2];
    }
}

HWY_INLINE void luminance_of_any(const GuideRecipe& recipe, const float* pixels, size_t n,
                                 size_t stride, float* y) {
    for (size_t i = 0; i < n; ++i)
        y[i] = 0.0f;
    for (int k = 0; k < 3; ++k) {
        if (recipe.channel[k] < 0)
            continue;
        const float weight = recipe.weight[k];
        const float* channel = pixels + recipe.channel[k];
        for (size_t i = 0; i < n; ++i)
            y[i] = y[i] + weight * channel[i * stride];
    }
}

/// Luminance of n pixels.
HWY_INLINE void luminance(const GuideRecipe& recipe, const float* pixels, size_t n, size_t stride,
                          float* y) {
    const int* k = recipe.channel;
    const bool first = k[0] == 0 && k[1] == 1 && k[2] == 2;
    if (first && stride == 3)
        luminance_of_first<3>(recipe.weight, pixels, n, y);
    else if (first && stride == 4)
        luminance_of_first<4>(recipe.weight, pixels, n, y);
    else
        luminance_of_any(recipe, pixels, n, stride, y);
}

/// How far below black nothing is: the outline of what covers it shows whatever its colour.
constexpr float share_of_alpha = 0.0f - guide_of_nothing;

/// What n pixels' guide lacks of share_of_alpha for each that is not covered. Alpha counts within 0
/// to 1, one that is not finite as 1.
HWY_INLINE void lack_of(const float* alpha, size_t n, size_t stride, float* lacking) {
    for (size_t i = 0; i < n; ++i) {
        const float a = alpha[i * stride];
        const auto bits = int32_t(bits_of(a)), one = int32_t(bits_of(1.0f));
        const int32_t low = bits < 0 ? 0 : bits;
        const float within = float_of(uint32_t(low < one ? low : one));
        const float shown = float_of(choose(is_finite(a), bits_of(within), bits_of(1.0f)));
        lacking[i] = share_of_alpha * (1.0f - shown);
    }
}

HWY_ATTR void make_guide(const GuideRecipe& recipe, const float* pixels, size_t count,
                         size_t stride, float* guide) {
    constexpr size_t block = 256;
    float y[block], lacking[block] = {};
    for (size_t begin = 0; begin < count; begin += block, pixels += block * stride) {
        const size_t n = std::min(block, count - begin);
        luminance(recipe, pixels, n, stride, y);
        if (recipe.alpha >= 0)
            lack_of(pixels + recipe.alpha, n, stride, lacking);
        // The curve's steps on exponents need a finite number.
        if (recipe.linear)
            for (size_t i = 0; i < n; ++i) {
                const float v = srgb_curve(y[i]);
                y[i] = float_of(choose(is_finite(y[i]), bits_of(v), 0));
            }
        // Nothing is lacking of what is opaque: it has the guide that it has without alpha.
        for (size_t i = 0; i < n; ++i)
            guide[begin + i] = guide_step(y[i]) - guide_step(lacking[i]);
    }
}

/// A row mixed with its neighbours to the left and right.
HWY_ATTR void blur_row(const float* row, size_t n, float own, float share, float* out) {
    const auto mix = [=](float before, float here, float after)
                         HWY_ATTR { return own * here + share * (before + after); };
    out[0] = mix(row[0], row[0], row[n > 1 ? 1 : 0]);
    for (size_t x = 1; x + 1 < n; ++x)
        out[x] = mix(row[x - 1], row[x], row[x + 1]);
    if (n > 1)
        out[n - 1] = mix(row[n - 2], row[n - 1], row[n - 1]);
}

/// A row mixed with those above and below it.
HWY_ATTR void blur_column(const float* above, const float* here, const float* below, size_t n,
                          float own, float share, float* out) {
    for (size_t x = 0; x < n; ++x)
        out[x] = guide_step(own * here[x] + share * (above[x] + below[x]));
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_guide);
HWY_EXPORT(blur_row);
HWY_EXPORT(blur_column);

namespace scalar {
namespace {
#include "core/guide/guide-inl.h"
} // namespace
} // namespace scalar

float srgb_curve(float light) {
    return scalar::srgb_curve(light);
}

float guide_step(float v) {
    return scalar::guide_step(v);
}

void clean_guide(float* guide, size_t n) {
    zero_unusual(guide, n, least_guide);
}

void make_guide(const GuideRecipe& recipe, const float* pixels, size_t count, int stride,
                float* guide) noexcept {
    const DenormalsAreZero whatever_the_caller_has;
    HWY_DYNAMIC_DISPATCH(make_guide)(recipe, pixels, count, size_t(stride), guide);
}

void blur_guide(float* guide, int width, int height, float share) {
    const DenormalsAreZero whatever_the_caller_has;
    const float own = 1.0f - 2.0f * share;
    const auto columns = size_t(width);
    std::vector<float> above(columns), here(columns), below(columns);
    const auto blur = [&](int y, std::vector<float>& out) {
        HWY_DYNAMIC_DISPATCH(blur_row)
        (guide + size_t(y) * columns, columns, own, share, out.data());
    };
    blur(0, here);
    above = here;
    for (int y = 0; y < height; ++y) {
        // The row below is still as it was.
        if (y < height - 1)
            blur(y + 1, below);
        else
            below = here;
        HWY_DYNAMIC_DISPATCH(blur_column)
        (above.data(), here.data(), below.data(), columns, own, share, guide + size_t(y) * columns);
        std::swap(above, here);
        std::swap(here, below);
    }
}

} // namespace ddt
#endif
