// SPDX-License-Identifier: Apache-2.0
// Alpha where a surface leaves the range of its pixels: it is bounded once it is read, not in the
// surface, which would then no longer be the one of the colours that are multiplied by it.
#pragma once

#include "core/lattice/locate.h"

namespace ddt {

/// One channel of the pixels of a lattice.
struct ChannelPixels {
    const float* first; ///< of the pixel in column 0, row 0
    int channels;       ///< floats from one pixel to the next
    int width, height;  ///< 2 pixels at least
};

/// What a surface over alpha has at p, bounded to 0 .. 1, or to the range of the four pixels of p's
/// cell where these leave that. NaN stays. GLSL twin: shaders/bound_alpha.glsl.
inline float bound_alpha(float f, const ChannelPixels& alpha, Point p) {
    if (!(f < 0.0f) && !(1.0f < f))
        return f;
    const int x = cell_of(p.x, alpha.width), y = cell_of(p.y, alpha.height);
    float low = 0.0f, high = 1.0f;
    for (int corner = 0; corner < 4; ++corner) {
        const ptrdiff_t pixel = ptrdiff_t(y + corner / 2) * alpha.width + (x + corner % 2);
        const float s = alpha.first[pixel * alpha.channels];
        low = s < low ? s : low;
        high = high < s ? s : high;
    }
    return f < low ? low : high < f ? high : f;
}

} // namespace ddt
