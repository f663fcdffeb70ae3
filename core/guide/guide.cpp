#include "core/guide/guide.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace ddt {
namespace {

uint32_t bits_of(float v) {
    uint32_t u;
    std::memcpy(&u, &v, sizeof u);
    return u;
}

float float_of(uint32_t u) {
    float v;
    std::memcpy(&v, &u, sizeof v);
    return v;
}

bool is_finite(float v) {
    return (bits_of(v) & 0x7f800000u) != 0x7f800000u;
}

// x^(5/12) for a normal positive x = m * 2^e, 1 <= m < 2, is 2^q * 2^(r/12) * m^(5/12) where
// 5e = 12q + r, 0 <= r < 12.
float power_5_12(float x) {
    static const float twelfth[12] = {1.0f,        1.05946314f, 1.12246203f, 1.18920708f,
                                      1.25992107f, 1.33483982f, 1.41421354f, 1.49830711f,
                                      1.58740103f, 1.68179286f, 1.78179741f, 1.8877486f};
    // m^(5/12) in t = m - 1, through seven digits at six Chebyshev-Lobatto points of [1, 2]: both
    // ends are among them, so neighbouring octaves meet. Largest relative error 2^-18.7.
    static const float c[6] = {1.0f,          0.416594565f,   -0.120247677f,
                               0.0571752861f, -0.0239196643f, 0.00523735536f};
    // Without the low 7 bits a step of the mantissa outweighs the rounding of what follows: the
    // curve can then not fall between neighbours.
    const uint32_t u = bits_of(x) & ~0x7fu;
    const int e5 = 5 * (int(u >> 23) - 127);
    const int q = (e5 + 12 * 128) / 12 - 128; // floor(5e / 12)
    const float t = float_of((u & 0x007fffffu) | 0x3f800000u) - 1.0f;
    float p = c[5];
    for (int k = 4; k >= 0; --k)
        p = p * t + c[k];
    return p * twelfth[e5 - 12 * q] * float_of(uint32_t(q + 127) << 23);
}

} // namespace

float srgb_curve(float light) {
    const float a = float_of(bits_of(light) & 0x7fffffffu);
    const float v = a <= 0.0031308f ? 12.92f * a : 1.055f * power_5_12(a) - 0.055f;
    return float_of(bits_of(v) | (bits_of(light) & 0x80000000u));
}

float guide_step(float v) {
    if (!is_finite(v))
        return 0.0f;
    const float steps = std::min(std::max(v, -1024.0f), 1024.0f) * 4096.0f;
    // Conversion to int drops the fraction: halves go away from 0, alike on both sides of it.
    return float(int32_t(steps < 0.0f ? steps - 0.5f : steps + 0.5f)) * (1.0f / 4096.0f);
}

void make_guide(const GuideRecipe& recipe, const float* pixels, size_t count, int stride,
                float* guide) {
    // What shows through where there is no alpha: the middle of the guide's range, in either light.
    const float grey = recipe.linear ? 0.21404114f : 0.5f;
    for (size_t i = 0; i < count; ++i, pixels += stride) {
        float y = 0.0f;
        for (int k = 0; k < 3; ++k)
            if (recipe.channel[k] >= 0)
                y = y + recipe.weight[k] * pixels[recipe.channel[k]];
        if (recipe.alpha >= 0) {
            const float alpha = pixels[recipe.alpha];
            if (is_finite(alpha))
                y = y + grey * (1.0f - std::min(std::max(alpha, 0.0f), 1.0f));
        }
        // The curve's steps on exponents need a finite number.
        guide[i] = !is_finite(y) ? 0.0f : guide_step(recipe.linear ? srgb_curve(y) : y);
    }
}

} // namespace ddt
