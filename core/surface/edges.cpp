// SPDX-License-Identifier: Apache-2.0
// The bends and softness of a net's edges.
#include <algorithm>
#include <cfloat>
#include <cstddef>

#include "core/base/arith.h"
#include "core/surface/edge_scratch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/edges.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "core/base/lanes-inl.h"
#include "core/base/rsqrt-inl.h"
#include "core/surface/gradient-inl.h"

using Lanes4 = Lanes<hn::CappedTag<float, group_size>>; // a lane a channel

#include "core/base/blocks-inl.h"

/// Weights of the flipped states of edges with these gains (see net.h), 0 to 1/2.
HWY_ATTR void soft_weights(const float* gain, int n, float reciprocal_tau, float* weights) {
    using Floats = Lanes<hn::ScalableTag<float>>;
    const int lanes = int(hn::Lanes(hn::ScalableTag<float>()));
    const Floats zero(0.0f), one(1.0f), share(soft_share), r(reciprocal_tau);
    const auto weigh = [&](Floats g) HWY_ATTR {
        const Floats w = one + if_less(g, zero, g, zero) * r;
        return if_less(zero, w, share * w, zero);
    };
    int i = 0;
    for (; i + lanes <= n; i += lanes)
        weigh(Floats::load(gain + i)).store(weights + i);
    for (; i < n; ++i) {
        const Floats w = weigh(Floats(gain[i]));
        weights[i] = hn::GetLane(w.v);
    }
}

/// e, if `bend`, and q, if `soft`, of the edges with midpoints at m, m + step, ... before end;
/// gradients: as at m; weights: of the edge at m.
template <bool bend, bool soft>
HWY_INLINE void make_any(const Lattice& lattice, ptrdiff_t m, ptrdiff_t end, int step,
                         const float* gradients, const float* weights, Net& net) {
    const ptrdiff_t stride = lattice.stride();
    // What is not wanted is null, and no offset from it is taken.
    for (; m < end;
         m += step, weights += soft ? step : 0, gradients += bend ? 2 * ptrdiff_t(step) : 0) {
        const uint64_t vectors = vectors_of(lattice.edge(int(m)));
        const int vx = int8_t(vectors), vy = int8_t(vectors >> 8);
        const ptrdiff_t to_j = vy * stride + vx;
        float* e = net.at(int(m));
        const Lanes4 zi = Lanes4::load(e - to_j * group_size),
                     zj = Lanes4::load(e + to_j * group_size);
        if (soft) {
            // An edge that cannot be flipped has weight 0; its apexes are read all the same.
            const ptrdiff_t to_c = int8_t(vectors >> 24) * stride + int8_t(vectors >> 16);
            const ptrdiff_t to_d = int8_t(vectors >> 40) * stride + int8_t(vectors >> 32);
            edge_softness(Lanes4(*weights), zi, zj, Lanes4::load(e + to_c * group_size),
                          Lanes4::load(e + to_d * group_size))
                .store(net.soft_at(int(m)));
        }
        if (bend) {
            // Where an end lies outside the part its gradient is not known, and e is never used.
            const float *gi = gradients - 2 * to_j, *gj = gradients + 2 * to_j;
            edge_bend(Lanes4::load(gi), Lanes4::load(gi + 2 * stride), Lanes4::load(gj),
                      Lanes4::load(gj + 2 * stride), zi, zj, Lanes4(float(vx)), Lanes4(float(vy)))
                .store(e);
        }
    }
}

/// Block k filled with p[2 k].
HWY_INLINE Blocks spread_every_second(const float* p) {
    const D d;
    const hn::RebindToSigned<D> di;
    const auto block = hn::ShiftLeft<1>(hn::ShiftRight<2>(hn::Iota(di, 0)));
    return hn::TableLookupLanes(hn::LoadU(d, p), hn::IndicesFromVec(d, block));
}

/// Where flag is 1 `yes`, where it is 0 `no`.
HWY_INLINE Blocks either(Blocks flag, Blocks yes, Blocks no) {
    return if_less(Blocks(0.0f), flag, yes, no);
}

/// Neighbouring edges of plain cells, as many as Blocks has: what belongs to their ends i and j and
/// their apexes c and d.
struct PlainEdges {
    Blocks zi, zj, zc, zd, gix, giy, gjx, gjy, vx, vy;

    /// q and e: of the edge whose midpoint comes first, the next two sites on; weights: of the
    /// first.
    template <bool bend, bool soft>
    HWY_INLINE void make(const float* weights, float* q, float* e) const {
        if (soft)
            store_every_second(edge_softness(spread_every_second(weights), zi, zj, zc, zd), q);
        if (bend)
            store_every_second(edge_bend(gix, giy, gjx, gjy, zi, zj, vx, vy), e);
    }
};

/// Edges next to one another, from the one at or beside the vertices of column x of row y on.
struct PlainMaker {
    const float* vertices[3];  ///< of the rows above, at and below y, from column 0 on
    const float* down_rows[2]; ///< of the cells above and below row y
    const float* gradients;    ///< those of row y, x of column 0
    ptrdiff_t to_y;            ///< from a gradient's x to its y
    ptrdiff_t row;             ///< from a gradient to that of the row below

    PlainMaker(const NearRows& rows, int y, const float* gradients_, ptrdiff_t stride)
        : vertices{rows.vertex(0, y + 2), rows.vertex(0, y), rows.vertex(0, y + 1)},
          down_rows{rows.cell_row(y + 1).down.data(), rows.cell_row(y).down.data()},
          gradients(gradients_), to_y(2 * stride), row(4 * stride) {}

    HWY_INLINE Blocks z(int x, int dy) const {
        return Blocks::load(vertices[dy + 1] + ptrdiff_t(x) * group_size);
    }
    HWY_INLINE Blocks gx(int x, int dy) const {
        return Blocks::load(gradients + dy * row + ptrdiff_t(x) * group_size);
    }
    HWY_INLINE Blocks gy(int x, int dy) const {
        return Blocks::load(gradients + dy * row + to_y + ptrdiff_t(x) * group_size);
    }
    /// 1 where cell (x, y + dy)'s diagonal is down.
    HWY_INLINE Blocks down(int x, int dy) const { return spread(down_rows[dy + 1] + x); }

    /// From (x, y) to (x + 1, y).
    template <bool bend>
    HWY_INLINE PlainEdges level(int x) const {
        PlainEdges e;
        e.zi = z(x, 0), e.zj = z(x + 1, 0);
        e.zc = either(down(x, 0), z(x + 1, 1), z(x, 1));
        e.zd = either(down(x, -1), z(x, -1), z(x + 1, -1));
        if (bend)
            e.gix = gx(x, 0), e.giy = gy(x, 0), e.gjx = gx(x + 1, 0), e.gjy = gy(x + 1, 0);
        e.vx = Blocks(1.0f), e.vy = Blocks(0.0f);
        return e;
    }
    /// From (x, y) to (x, y + 1).
    template <bool bend>
    HWY_INLINE PlainEdges upright(int x) const {
        PlainEdges e;
        e.zi = z(x, 0), e.zj = z(x, 1);
        e.zc = either(down(x - 1, 0), z(x - 1, 0), z(x - 1, 1));
        e.zd = either(down(x, 0), z(x + 1, 1), z(x + 1, 0));
        if (bend)
            e.gix = gx(x, 0), e.giy = gy(x, 0), e.gjx = gx(x, 1), e.gjy = gy(x, 1);
        e.vx = Blocks(0.0f), e.vy = Blocks(1.0f);
        return e;
    }
    /// The diagonal of cell (x, y), from its upper to its lower end.
    template <bool bend>
    HWY_INLINE PlainEdges diagonal(int x) const {
        PlainEdges e;
        const Blocks flag = down(x, 0);
        const Blocks z0 = z(x, 0), z1 = z(x + 1, 0), z2 = z(x, 1), z3 = z(x + 1, 1);
        e.zi = either(flag, z0, z1), e.zj = either(flag, z3, z2);
        e.zc = either(flag, z2, z0), e.zd = either(flag, z1, z3);
        if (bend) {
            e.gix = either(flag, gx(x, 0), gx(x + 1, 0)),
            e.giy = either(flag, gy(x, 0), gy(x + 1, 0));
            e.gjx = either(flag, gx(x + 1, 1), gx(x, 1)),
            e.gjy = either(flag, gy(x + 1, 1), gy(x, 1));
        }
        e.vx = either(flag, Blocks(1.0f), Blocks(-1.0f)), e.vy = Blocks(1.0f);
        return e;
    }
};

/// The edges with midpoints in row y of the doubled lattice.
template <bool bend, bool soft>
HWY_INLINE void make_row(const Lattice& lattice, const Rect& part, int y, EdgeScratch& scratch,
                         Net& net) {
    const int odd = y & 1, step = blocks_in_vector(), last_x = lattice.width() - 1;
    const int pixel_y = y / 2;
    const ptrdiff_t stride = lattice.stride(), first = lattice.site(2 * part.x0 + 1 - odd, y),
                    end = lattice.site(2 * part.x1 - 1, y);
    const float* weights = scratch.weights.data();
    const NearRows& rows = scratch.edge_rows;
    // Without bends there are none.
    const auto gradients_at = [&](int site) { return bend ? scratch.gradients_at(site) : nullptr; };
    const PlainMaker plain(rows, pixel_y, gradients_at(lattice.vertex_site(0, pixel_y)), stride);
    float* const e = net.at(int(first));
    float* const q = soft ? net.soft_at(int(first)) : nullptr;
    const uint8_t *above = rows.cell_row(pixel_y + 1).other.data(),
                  *here = rows.cell_row(pixel_y).other.data();
    // Whether the cells beside the edges of a vector's columns are plain.
    const uint8_t* other = odd ? here : above;
    const auto is_plain = [&](int x) {
        int others = here[x - odd];
        for (int k = x; k < x + step; ++k)
            others |= other[k] | here[k];
        return !others;
    };
    const bool inner = odd || (pixel_y > 0 && pixel_y < lattice.height() - 1);
    for (int x = part.x0; x < part.x1; x += step) {
        // The first of the edges beside column x, and of those after the last of them.
        const ptrdiff_t m = lattice.site(2 * x + 1 - odd, y), next = m + 2 * step;
        const float* w = soft ? weights + (m - first) : nullptr;
        const ptrdiff_t at = (m - first) * group_size;
        if (inner && next <= end && x > 0 && x + step <= last_x && is_plain(x)) {
            if (odd) {
                const float* after = soft ? w + 1 : nullptr;
                float* const q_at = soft ? q + at : nullptr;
                plain.template upright<bend>(x).template make<bend, soft>(w, q_at, e + at);
                plain.template diagonal<bend>(x).template make<bend, soft>(
                    after, soft ? q_at + group_size : nullptr, e + at + group_size);
            } else {
                plain.template level<bend>(x).template make<bend, soft>(w, soft ? q + at : nullptr,
                                                                        e + at);
            }
        } else {
            make_any<bend, soft>(lattice, m, std::min(next, end), 2 - odd, gradients_at(int(m)), w,
                                 net);
        }
    }
}

HWY_ATTR void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend,
                         const float* gain, float reciprocal_tau, EdgeScratch& scratch, Net& net) {
    if (y0 == 2 * part.y0)
        scratch.edge_rows.begin(lattice, part, part.y0, net);
    for (int y = y0; y < y1; ++y) {
        if (y % 2 == 0)
            scratch.edge_rows.load_below(lattice, part, y / 2, net);
        const int m = lattice.site(2 * part.x0 + 1 - (y & 1), y),
                  end = lattice.site(2 * part.x1 - 1, y);
        if (gain)
            soft_weights(gain + m, end - m, reciprocal_tau, scratch.weights.data());
        if (bend && gain)
            make_row<true, true>(lattice, part, y, scratch, net);
        else if (bend)
            make_row<true, false>(lattice, part, y, scratch, net);
        else if (gain)
            make_row<false, true>(lattice, part, y, scratch, net);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_edges);

void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend,
                const float* gain, float reciprocal_tau, EdgeScratch& scratch, Net& net) {
    HWY_DYNAMIC_DISPATCH(make_edges)
    (lattice, part, y0, y1, bend, gain, reciprocal_tau, scratch, net);
}

} // namespace ddt
#endif
