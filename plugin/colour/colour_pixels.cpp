// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/colour_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace ddt {
namespace {

/// By what to divide each channel of a pixel's colour before it is converted.
void find_cover(const Light& light, float alpha, const float* rgb, float* cover) {
    // Where 0 and 1 are not 0 and 1 in linear light, as in logarithmic encodings, or channels mix,
    // the largest colour is not the same number on the way back; and a quotient that is large would
    // be without measure in linear light.
    if (!std::isfinite(alpha) || !light.keeps_unit()) {
        std::fill_n(cover, 3, 1.0f);
        return;
    }
    float of_all = alpha;
    for (int k = 0; k < 3; ++k)
        if (std::isfinite(rgb[k])) // one bad number must not spoil the others
            of_all = std::max(of_all, std::min(rgb[k], 1.0f));
    for (int k = 0; k < 3; ++k) {
        // What a filter that rings leaves of a colour is glow of its own, the other way.
        const float own = std::max(of_all, std::min(-rgb[k], 1.0f));
        cover[k] = own > 0x1p-100f ? own : 1.0f; // the quotient must not overflow
    }
}

template <class Convert, class AlikeConvert>
void convert(const Light& light, const ColourLayout& layout, float* pixels, size_t count,
             int stride, Convert&& rgb_convert, AlikeConvert&& alike_convert) {
    if (as_they_are(light, layout))
        return;
    if (all_alike(light, layout, stride)) {
        alike_convert(pixels, count * size_t(stride));
        return;
    }
    // Grey is the colour (y, y, y).
    const int at[3] = {layout.channel[0], layout.channel[layout.count == 3 ? 1 : 0],
                       layout.channel[layout.count == 3 ? 2 : 0]};
    constexpr size_t block = 256;
    float rgb[3 * block], cover[3 * block];
    for (size_t begin = 0; begin < count; begin += block, pixels += block * stride) {
        const size_t n = std::min(block, count - begin);
        for (size_t i = 0; i < n; ++i)
            for (int k = 0; k < 3; ++k)
                rgb[3 * i + k] = pixels[i * stride + at[k]];
        if (layout.alpha >= 0)
            for (size_t i = 0; i < n; ++i) {
                find_cover(light, pixels[i * stride + layout.alpha], rgb + 3 * i, cover + 3 * i);
                for (int k = 0; k < 3; ++k)
                    rgb[3 * i + k] /= cover[3 * i + k];
            }
        rgb_convert(rgb, n);
        if (layout.alpha >= 0)
            for (size_t i = 0; i < 3 * n; ++i)
                rgb[i] *= cover[i];
        for (size_t i = 0; i < n; ++i)
            for (int k = 0; k < layout.count; ++k)
                pixels[i * stride + at[k]] = rgb[3 * i + k];
    }
}

} // namespace

bool as_they_are(const Light& light, const ColourLayout& layout) {
    return !light.converts() || layout.count == 0;
}

bool all_alike(const Light& light, const ColourLayout& layout, int stride) {
    return layout.alpha < 0 && layout.count == stride && light.alike();
}

std::vector<float>
light_of_codes(const Light& light, const ColourLayout& layout, int stride, int bits,
               const std::function<void(const void* numbers, int n, float* values)>& floats) {
    const bool converts = !as_they_are(light, layout);
    if (converts && !all_alike(light, layout, stride))
        return {};
    std::vector<uint16_t> numbers(size_t(1) << bits);
    std::iota(numbers.begin(), numbers.end(), uint16_t(0));
    const std::vector<uint8_t> bytes(numbers.begin(), numbers.begin() + 256);
    std::vector<float> values(numbers.size());
    floats(bits == 8 ? static_cast<const void*>(bytes.data()) : numbers.data(), int(values.size()),
           values.data());
    if (converts)
        light.to_light_alike(values.data(), values.size());
    return values;
}

GuideRecipe guide_recipe(const Light& light, const ColourLayout& layout, bool linear) {
    GuideRecipe guide;
    guide.linear = linear;
    guide.alpha = layout.alpha;
    for (int k = 0; k < layout.count; ++k) {
        guide.channel[k] = layout.channel[k];
        guide.weight[k] = layout.count == 3 ? light.luma()[size_t(k)] : 1.0f;
    }
    return guide;
}

void to_light(const Light& light, const ColourLayout& layout, float* pixels, size_t count,
              int stride) {
    convert(
        light, layout, pixels, count, stride, [&](float* rgb, size_t n) { light.to_light(rgb, n); },
        [&](float* values, size_t n) { light.to_light_alike(values, n); });
}

void from_light(const Light& light, const ColourLayout& layout, float* pixels, size_t count,
                int stride) {
    convert(
        light, layout, pixels, count, stride,
        [&](float* rgb, size_t n) { light.from_light(rgb, n); },
        [&](float* values, size_t n) { light.from_light_alike(values, n); });
}

} // namespace ddt
