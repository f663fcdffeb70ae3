// SPDX-License-Identifier: Apache-2.0
// Pictures that are hard on equality.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/core/gl/enlarge_pair.h"

namespace ddt::test {

enum class Content { photo, noise, drawing, flat, hdr, nonfinite, tiny, count };

inline const char* name_of(Content content) {
    const char* const names[] = {"photo", "noise", "drawing", "flat", "hdr", "nonfinite", "tiny"};
    return names[int(content)];
}

/// Smooth shades, circles and stripes with a little noise; the guide a multiple of 2^-12 like the
/// real one's, but for Content::noise, whose guide has all its bits.
inline Picture make_picture(Content content, int width, int height, int channels, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    Picture p{width, height, channels, {}, {}};
    const float angle = 6.28f * uniform(random), cx = float(width) * uniform(random),
                cy = float(height) * uniform(random), period = 5.0f + 30.0f * uniform(random);
    const auto special = [&](float v) {
        const int kind = int(random() % 60);
        const float infinity = std::numeric_limits<float>::infinity();
        return kind == 0   ? std::numeric_limits<float>::quiet_NaN()
               : kind == 1 ? infinity
               : kind == 2 ? -infinity
               : kind == 3 ? -0.0f
               : kind == 4 ? 3e38f
               : kind == 5 ? -3e38f
                           : v;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = float(x) * std::cos(angle) + float(y) * std::sin(angle);
            const float r = std::hypot(float(x) - cx, float(y) - cy);
            float v = 0.5f + 0.2f * std::sin(u / period) +
                      (std::fmod(r, 40.0f) < 20 ? 0.2f : 0.0f) + 0.02f * uniform(random);
            switch (content) {
            case Content::noise:
                v = uniform(random);
                break;
            case Content::drawing:
                v = std::fmod(u + 1000.0f, period) < period / 3 ? 0.0f : 1.0f;
                break;
            case Content::flat:
                v = random() % 97 == 0 ? 0.0f : -0.0f;
                break;
            case Content::hdr:
                v = random() % 50 == 0 ? 1000.0f * uniform(random) : v;
                break;
            case Content::tiny:
                v = (random() % 2 ? 1e-38f : 1e-23f) * (uniform(random) - 0.5f);
                break;
            default:
                break;
            }
            for (int c = 0; c < channels; ++c) {
                float value = v * (1.0f - 0.1f * float(c % 5));
                if (content == Content::nonfinite)
                    value = special(value);
                p.values.push_back(value);
            }
            const float step = content == Content::noise ? v : std::round(v * 4096.0f) / 4096.0f;
            p.guide.push_back(content == Content::tiny ? v : std::min(step, 8.0f));
        }
    return p;
}

} // namespace ddt::test
