// SPDX-License-Identifier: Apache-2.0
// The formulas of core/surface/control_net.h and of evaluation, one channel, one position at a
// time, on triangles that were enumerated: no fans, no vectors, no rows. Call under
// DenormalsAreZero.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/base/arith.h"
#include "core/base/float_mode.h"
#include "core/surface/control_net.h"
#include "tests/core/lattice/faces.h"
#include "tests/core/lattice/flipping.h"

namespace ddt::test {

class SlowSurface {
public:
    /// `values` is one float a pixel.
    SlowSurface(const std::vector<Face>& faces, int width, int height, Surface surface,
                const std::vector<float>& values)
        : m_width(width), m_values(values) {
        if (surface == Surface::linear)
            return;
        std::map<Pixel, Ring> rings;
        for (const Face& f : faces)
            for (size_t k = 0; k < 3; ++k) {
                const Pixel p = f[k], j = f[(k + 1) % 3] - p, l = f[(k + 2) % 3] - p;
                rings[p].after[j] = l;
                rings[p].before[l] = j;
            }
        std::map<Pixel, Gradient> gradients;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                gradients[{x, y}] = gradient({x, y}, rings[{x, y}]);
        for (const Face& f : faces)
            for (size_t k = 0; k < 3; ++k) {
                const Pixel i = f[k], j = f[(k + 1) % 3];
                m_bends[i + j] = bend(i, j, gradients[i], gradients[j]);
            }
    }

    float z(Pixel p) const { return m_values[size_t(p.y * m_width + p.x)]; }
    /// e of the edge from i to j; 0 for Surface::linear.
    float e(Pixel i, Pixel j) const {
        const auto found = m_bends.find(i + j);
        return found == m_bends.end() ? 0.0f : found->second;
    }

    /// Blend the edges with their flipped state (SurfaceOptions::soft) by their gains.
    void soften(const Lattice& lattice, float tau, Bounds bounds) {
        m_soft = true;
        m_bounds = bounds;
        for (const int m : flippable_edges(lattice)) {
            const EdgeView v = view(lattice, m);
            const float g = lattice.gain(m), w = 1.0f + (g < 0 ? g : 0.0f) * (1.0f / tau);
            const float d = (z(v.left) + z(v.right)) - (z(v.a) + z(v.b));
            const float q = (w > 0 ? 0.5f * w : 0.0f) * d;
            m_softness[v.a + v.b] = w > 0 && std::fabs(q) <= FLT_MAX ? bounded(q, v) : 0.0f;
        }
    }
    struct Range {
        float low, high;
    };
    /// What a triangle with this range of vertices is cut off at.
    Range cut_off(float low, float high) const {
        if (m_bounds == Bounds::vertices)
            return {low, high};
        return {m_bounds == Bounds::dark && low >= 0 ? 0.5f * low : -HUGE_VALF, HUGE_VALF};
    }
    /// q with which the edge's middle stays within what both its triangles are cut off at.
    float bounded(float q, const EdgeView& v) const {
        const float ends = z(v.a) + z(v.b), bend = e(v.a, v.b);
        for (const Pixel apex : {v.left, v.right}) {
            const auto [lowest, highest] = std::minmax({z(v.a), z(v.b), z(apex)});
            const Range range = cut_off(lowest, highest);
            const float least = (2 * range.low - ends) - 0.5f * bend;
            const float most = (2 * range.high - ends) - 0.5f * bend;
            q = std::clamp(q, std::min(least, 0.0f), std::max(most, 0.0f));
        }
        return q;
    }
    float q(Pixel i, Pixel j) const {
        const auto found = m_softness.find(i + j);
        return found == m_softness.end() ? 0.0f : found->second;
    }

    /// F in a triangle at weights in 2^-16.
    float at(const Face& f, const int32_t w[3]) const {
        float b[3], z3[3];
        for (size_t k = 0; k < 3; ++k) {
            b[k] = float(w[k]) / 65536.0f;
            z3[k] = z(f[k]);
        }
        const auto term = [&](size_t k) { return w[k] == 0 ? 0.0f : b[k] * z3[k]; };
        float r = term(0) + term(1) + term(2);
        if (!m_bends.empty())
            r = r + ((b[0] * b[1] * e(f[0], f[1]) + b[1] * b[2] * e(f[1], f[2])) +
                     b[2] * b[0] * e(f[2], f[0]));
        if (m_soft)
            r = r + ((std::min(b[0], b[1]) * q(f[0], f[1]) + std::min(b[1], b[2]) * q(f[1], f[2])) +
                     std::min(b[2], b[0]) * q(f[2], f[0]));
        // Not a number among the three: no limit from it, and the result says so itself.
        float low = z3[1] < z3[0] ? z3[1] : z3[0], high = z3[0] < z3[1] ? z3[1] : z3[0];
        low = z3[2] < low ? z3[2] : low;
        high = high < z3[2] ? z3[2] : high;
        const Range range = cut_off(low, high);
        r = r < range.low ? range.low : r;
        r = range.high < r ? range.high : r;
        return r == r ? r + 0.0f : float_of(0x7fc00000); // zero without sign
    }

private:
    struct Ring {
        std::map<Pixel, Pixel> after, before; ///< triangles p, p + j, p + k: j -> k and k -> j
    };
    struct Gradient {
        float x = 0, y = 0;
    };

    Gradient gradient(Pixel p, const Ring& ring) const {
        // From the edge with the smallest address to the left; at the rim also to the right.
        Pixel first = ring.after.begin()->first;
        for (const auto& [j, k] : ring.after)
            first = std::min({first, j, k});
        std::vector<std::pair<Pixel, Pixel>> order;
        Pixel j = first;
        do {
            const auto next = ring.after.find(j);
            if (next == ring.after.end())
                break;
            order.push_back(*next);
            j = next->second;
        } while (j != first);
        if (order.size() < ring.after.size())
            for (Pixel k = first; ring.before.count(k); k = ring.before.at(k))
                order.push_back({ring.before.at(k), k});

        Gradient base, sum;
        float weight = 0;
        for (size_t i = 0; i < order.size(); ++i) {
            const Pixel a = order[i].first, b = order[i].second;
            const float da = z(p + a) - z(p), db = z(p + b) - z(p);
            Gradient g{da * float(b.y) - db * float(a.y), db * float(a.x) - da * float(b.x)};
            const float square = g.x * g.x + g.y * g.y;
            float w = 0;
            if (square <= FLT_MAX)
                w = scalar::rsqrt<1>(square + gradient_epsilon);
            else
                g = {};
            if (i == 0)
                base = g;
            sum.x = sum.x + w * (g.x - base.x);
            sum.y = sum.y + w * (g.y - base.y);
            weight = weight + w;
        }
        const float r = scalar::rsqrt<3>(weight > 0 ? weight : 1.0f);
        return {base.x + sum.x * (r * r), base.y + sum.y * (r * r)};
    }

    float bend(Pixel i, Pixel j, Gradient gi, Gradient gj) const {
        const float limit = std::fabs(z(j) - z(i));
        if (!(limit <= FLT_MAX))
            return 0;
        const Pixel v = j - i;
        const float e = 1.75f * ((gi.x - gj.x) * float(v.x) + (gi.y - gj.y) * float(v.y));
        return e < -limit ? -limit : e > limit ? limit : e;
    }

    int m_width;
    std::vector<float> m_values;
    std::map<Pixel, float> m_bends, m_softness;
    bool m_soft = false;
    Bounds m_bounds = Bounds::vertices;
};

} // namespace ddt::test
