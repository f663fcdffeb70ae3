// SPDX-License-Identifier: Apache-2.0
// Colour conversion of interleaved pixels, round their alpha.
#pragma once

#include <functional>
#include <vector>

#include "ddt/guide.h"
#include "plugin/colour/layout.h"
#include "plugin/colour/light.h"

namespace ddt {

/// True if to_light() and from_light() change no number.
bool as_they_are(const Light& light, const ColourLayout& layout);

/// True if the pixels are nothing but numbers that all convert alike, each by itself.
bool all_alike(const Light& light, const ColourLayout& layout, int stride);

/// Where every number converts by itself, all alike or not at all: the linear light of the numbers
/// 0 to 255 of 8 bits, or 0 to 65535 of 16, of which `floats(numbers, n, values)` makes floats;
/// else nothing.
std::vector<float>
light_of_codes(const Light& light, const ColourLayout& layout, int stride, int bits,
               const std::function<void(const void* numbers, int n, float* values)>& floats);

/// How edges are sought in pixels of this colour, whose numbers are linear light or, if not
/// `linear`, seen as they are.
GuideRecipe guide_recipe(const Light& light, const ColourLayout& layout, bool linear);

/// Convert the colour of `count` pixels of `stride` floats each, in place, to linear light.
///
/// Colour that is associated with an alpha is divided by it for the conversion and multiplied
/// again after it. Glow, colour brighter than its alpha (up to alpha 0), counts as full light of
/// as much coverage as the brightest channel, up to 1: so it converts there and back to itself, and
/// where its channels change together it fades in and out without a seam. Where one glows alone,
/// what covers the others changes with it, and leaves a rim in them. A channel that is negative by
/// more than that does so by itself. Where 0 and 1 of an encoding are not 0 and 1 in linear light
/// (logarithmic ones), or it is no curve a channel, colour is converted as it is.
void to_light(const Light& light, const ColourLayout& layout, float* pixels, size_t count,
              int stride);
/// The way back.
void from_light(const Light& light, const ColourLayout& layout, float* pixels, size_t count,
                int stride);

} // namespace ddt
