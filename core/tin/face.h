// SPDX-License-Identifier: Apache-2.0
// What costs need to know of a triangle of any shape. GLSL twin: shaders/tin.glsl.
#pragma once

#include <cstdint>
#include <cstring>

#include "core/base/float_bits.h"
#include "core/cost/cost.h"
#include "core/tin/tin.h"

namespace ddt {

/// A cost's Face, whatever the cost, and twice the triangle's area in square pixels.
struct TinFace {
    float face[3];
    float doubled_area;
};

namespace scalar {

/// 1/x for x > 0, within 2 units of the last place; of a power of two exactly.
inline float reciprocal(float x) {
    float y = float_of(uint32_t(reciprocal_magic) - bits_of(x));
    // Newton's steps by the remainder: it gets exact, so the last step can repair the rounding.
    for (int i = 0; i < 4; ++i)
        y = y + y * (1.0f - x * y);
    return y;
}

/// A whole number below 2^62 as a float, by its halves, as GPUs have it.
inline float to_float(int64_t x) {
    return float(uint32_t(x >> 32)) * 4294967296.0f + float(uint32_t(x));
}

template <class Cost>
TinFace pack(const typename Cost::Face& f, float doubled_area) {
    TinFace packed{{}, doubled_area};
    static_assert(sizeof f <= sizeof packed.face, "a face is up to three floats");
    std::memcpy(packed.face, &f, sizeof f);
    return packed;
}
template <class Cost>
typename Cost::Face unpack(const TinFace& packed) {
    typename Cost::Face f;
    std::memcpy(&f, packed.face, sizeof f);
    return f;
}

/// The face of the triangle p, q, r with positive orientation `doubled_area`, in steps.
template <class Cost>
TinFace face_of(const Tin::Vertex& p, const Tin::Vertex& q, const Tin::Vertex& r,
                int64_t doubled_area, float pixel) {
    const float ex = float(q.at.x - p.at.x) * pixel, ey = float(q.at.y - p.at.y) * pixel;
    const float ox = float(r.at.x - p.at.x) * pixel, oy = float(r.at.y - p.at.y) * pixel;
    const float de = q.guide - p.guide, d_o = r.guide - p.guide;
    const float area = (to_float(doubled_area) * pixel) * pixel;
    const float scale = reciprocal(area);
    return pack<Cost>(
        Cost::face(((de * oy) - (d_o * ey)) * scale, ((d_o * ex) - (de * ox)) * scale), area);
}

/// The cost of the edge from p to q between two triangles.
template <class Cost>
float between(const TinFace& a, const TinFace& b, Steps p, Steps q, float pixel) {
    return Cost::between(unpack<Cost>(a), unpack<Cost>(b), float(q.x - p.x) * pixel,
                         float(q.y - p.y) * pixel, Doubled<float>{a.doubled_area, b.doubled_area});
}

} // namespace scalar
} // namespace ddt
