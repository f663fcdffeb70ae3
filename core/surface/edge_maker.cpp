#include "core/surface/edge_maker.h"

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <cstring>

#include "core/arith/arith.h"
#include "core/large_pages.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/edge_maker.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "core/arith/lanes-inl.h"
#include "core/arith/rsqrt-inl.h"
#include "core/surface/gradient-inl.h"

using Lanes4 = Lanes<hn::CappedTag<float, group_size>>; // a lane a channel

/// A neighbour of the vertex that is walked round, over the edge between them.
struct Spoke {
    int x, y;      ///< the neighbour relative to the vertex in pixels: the edge's midpoint in
                   ///< doubled coordinates
    Lanes4 fx, fy; ///< the same
    Lanes4 dz;     ///< difference of the values

    HWY_INLINE Spoke(int x_, int y_, Lanes4 z, const float* net, int stride)
        : x(x_), y(y_), fx(float(x_)), fy(float(y_)),
          dz(Lanes4::load(net + 2 * group_size * ptrdiff_t(y_ * stride + x_)) - z) {}
};

/// The next spoke to the left or right of one; false on the rim. On the record as one number: the
/// walk is a chain of such steps, and its latency is what a gradient costs.
HWY_INLINE bool next_spoke(const Site* vertex, int stride, bool left, int& x, int& y) {
    static_assert(offsetof(Edge, v) == 0 && offsetof(Edge, left) == 2 && offsetof(Edge, right) == 4,
                  "the shifts below");
    uint64_t record;
    std::memcpy(&record, vertex + (ptrdiff_t(y) * stride + x), sizeof record);
    const bool outwards = uint16_t(record) == uint16_t((x & 255) | (y & 255) << 8);
    const auto apex = uint16_t(record >> (outwards == left ? 16 : 32));
    x = (x + int8_t(apex)) >> 1;
    y = (y + int8_t(apex >> 8)) >> 1;
    return apex != 0;
}

/// The mean gradient at a vertex: over its triangles in a fixed order, from the first edge to the
/// left, and on the hull's rim from the first edge to the right.
HWY_INLINE GradientMean<Lanes4> mean_round(const Site* vertex, const float* net, int stride) {
    GradientMean<Lanes4> mean;
    const Lanes4 z = Lanes4::load(net);
    const Vec first = vertex->vertex.first;
    const Spoke start(first.x, first.y, z, net, stride);
    Spoke last = start;
    int x = first.x, y = first.y;
    while (next_spoke(vertex, stride, true, x, y)) {
        const Spoke next(x, y, z, net, stride);
        mean.add(last.fx, last.fy, next.fx, next.fy, last.dz, next.dz);
        if (x == first.x && y == first.y)
            return mean;
        last = next;
    }
    x = first.x;
    y = first.y;
    last = start;
    while (next_spoke(vertex, stride, false, x, y)) {
        const Spoke next(x, y, z, net, stride);
        mean.add(next.fx, next.fy, last.fx, last.fy, next.dz, last.dz);
        last = next;
    }
    return mean;
}

// One vertex a block of group_size lanes.
using D = hn::CappedTag<float, 4 * group_size>;
using Blocks = Lanes<D>;

/// Vertices in a vector.
HWY_INLINE int blocks_in_vector() {
    return int(hn::Lanes(D())) / group_size;
}

/// Block k filled with p[k].
HWY_INLINE Blocks spread(const float* p) {
    const D d;
    const hn::RebindToSigned<D> di;
    const auto block = hn::ShiftRight<2>(hn::Iota(di, 0));
    return hn::TableLookupLanes(hn::LoadU(d, p), hn::IndicesFromVec(d, block));
}

/// Gradients at plain vertices x, x + 1, ... of row y, as many as Blocks has.
HWY_INLINE void plain_gradients(const EdgeScratch& scratch, int x, int y, float* to,
                                ptrdiff_t to_y) {
    const auto row = [&](int at) { return scratch.vertices[at % 3].data() + x * group_size; };
    const float *above = row(y + 2), *here = row(y), *below = row(y + 1);
    const Blocks z = Blocks::load(here);
    const auto difference = [&](const float* p) HWY_ATTR { return Blocks::load(p) - z; };
    Differences<Blocks> d;
    d.nw = difference(above - group_size);
    d.n = difference(above);
    d.ne = difference(above + group_size);
    d.e = difference(here + group_size);
    d.se = difference(below + group_size);
    d.s = difference(below);
    d.sw = difference(below - group_size);
    d.w = difference(here - group_size);
    const float *upper = scratch.cells[(y + 1) % 2].down.data() + x,
                *lower = scratch.cells[y % 2].down.data() + x;
    const Blocks one(1.0f);
    Blocks gx, gy;
    plain_mean(d, spread(upper - 1), one - spread(upper), spread(lower), one - spread(lower - 1))
        .result(gx, gy);
    gx.store(to);
    gy.store(to + to_y);
}

void load_vertices(const Lattice& lattice, const Rect& part, int y, const Net& net,
                   EdgeScratch& scratch) {
    auto& row = scratch.vertices[y % 3];
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1 + 1, lattice.width());
    const float* z = net.at(lattice.vertex_site(begin, y));
    for (int x = begin; x < end; ++x, z += 2 * group_size)
        std::memcpy(&row[size_t(x) * group_size], z, group_size * sizeof(float));
}

void load_cells(const Lattice& lattice, const Rect& part, int y, EdgeScratch& scratch) {
    CellRow& row = scratch.cells[y % 2];
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1, lattice.width() - 1);
    const Division* divisions = lattice.divisions(y);
    for (int x = begin; x < end; ++x) {
        row.down[size_t(x)] = divisions[x] == Division::down ? 1.0f : 0.0f;
        row.other[size_t(x)] = divisions[x] == Division::other;
    }
}

/// Gradients at the vertices of rows y0 .. y1 - 1 of pixels; those of the row before y0 were made
/// last, if it is in the part.
HWY_ATTR void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1,
                             const Net& net, EdgeScratch& scratch) {
    const int stride = lattice.stride(), last_x = lattice.width() - 1,
              last_y = lattice.height() - 1;
    const auto load_below = [&](int y) {
        if (y < 0 || y > last_y)
            return;
        load_vertices(lattice, part, y, net, scratch);
        if (y > 0)
            load_cells(lattice, part, y - 1, scratch);
    };
    if (y0 == part.y0) {
        if (y0 > 0)
            load_vertices(lattice, part, y0 - 1, net, scratch);
        load_below(y0);
    }
    const int begin = std::max(part.x0, 1), end = std::min(part.x1, last_x);
    const int step = blocks_in_vector();
    for (int y = y0; y < y1; ++y) {
        load_below(y + 1);
        const auto gradients_at = [&](int x) {
            return scratch.gradients.data() + 2 * size_t(lattice.vertex_site(x, y));
        };
        const auto walk_round = [&](int x) HWY_ATTR {
            const int s = lattice.vertex_site(x, y);
            Lanes4 gx, gy;
            mean_round(lattice.sites() + s, net.at(s), stride).result(gx, gy);
            gx.store(gradients_at(x));
            gy.store(gradients_at(x) + 2 * ptrdiff_t(stride));
        };
        if (y == 0 || y == last_y || end - begin < step) {
            for (int x = part.x0; x < part.x1; ++x)
                walk_round(x);
            continue;
        }
        if (part.x0 < begin)
            walk_round(part.x0);
        if (part.x1 > end)
            walk_round(end);
        const uint8_t *above = scratch.cells[(y + 1) % 2].other.data(),
                      *below = scratch.cells[y % 2].other.data();
        const auto crossed = [&](int cell) { return above[cell] | below[cell]; };
        for (int next = begin; next < end; next += step) {
            const int x = std::min(next, end - step); // the last vector may repeat some
            plain_gradients(scratch, x, y, gradients_at(x), 2 * ptrdiff_t(stride));
            int any = 0;
            for (int k = x - 1; k < x + step; ++k)
                any |= crossed(k);
            for (int k = x; any && k < x + step; ++k)
                if (crossed(k - 1) | crossed(k))
                    walk_round(k);
        }
    }
}

/// Weights of the flipped states of edges with these gains (see net.h), 0 to 1/2.
HWY_ATTR void soft_weights(const float* gain, int n, float reciprocal_tau, float* weights) {
    using Floats = Lanes<hn::ScalableTag<float>>;
    const int lanes = int(hn::Lanes(hn::ScalableTag<float>()));
    const Floats zero(0.0f), one(1.0f), half(0.5f), r(reciprocal_tau);
    const auto weigh = [&](Floats g) HWY_ATTR {
        const Floats w = one + if_less(g, zero, g, zero) * r;
        return if_less(zero, w, half * w, zero);
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
/// weights: of the edge at m.
template <bool bend, bool soft>
HWY_INLINE void make_row(const Lattice& lattice, ptrdiff_t m, ptrdiff_t end, int step,
                         const float* gradients, const float* weights, Net& net) {
    const ptrdiff_t stride = lattice.stride();
    for (; m < end; m += step, weights += step) {
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
                .store(net.soft.data() + m * group_size);
        }
        if (bend) {
            // Where an end lies outside the part its gradient is not known, and e is never used.
            const float *gi = gradients + 2 * (m - to_j), *gj = gradients + 2 * (m + to_j);
            edge_bend(Lanes4::load(gi), Lanes4::load(gi + 2 * stride), Lanes4::load(gj),
                      Lanes4::load(gj + 2 * stride), zi, zj, Lanes4(float(vx)), Lanes4(float(vy)))
                .store(e);
        }
    }
}

/// The edges with midpoints in rows y0 .. y1 - 1 of the doubled lattice.
HWY_ATTR void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend,
                         const float* gain, float reciprocal_tau, EdgeScratch& scratch, Net& net) {
    for (int y = y0; y < y1; ++y) {
        const int odd = y & 1;
        const int m = lattice.site(2 * part.x0 + 1 - odd, y),
                  end = lattice.site(2 * part.x1 - 1, y);
        const float *g = scratch.gradients.data(), *w = scratch.weights.data();
        if (gain)
            soft_weights(gain + m, end - m, reciprocal_tau, scratch.weights.data());
        if (bend && gain)
            make_row<true, true>(lattice, m, end, 2 - odd, g, w, net);
        else if (bend)
            make_row<true, false>(lattice, m, end, 2 - odd, g, w, net);
        else if (gain)
            make_row<false, true>(lattice, m, end, 2 - odd, g, w, net);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_gradients);
HWY_EXPORT(make_edges);

namespace {

/// Floats beyond the last of a row that may be read or written.
constexpr size_t padding = 4 * group_size;

/// Rows of pixels that are made at a time, at least.
constexpr int rows_at_once = 8;

size_t gradient_count(size_t sites) {
    return 2 * sites + padding;
}

} // namespace

void EdgeMaker::reserve(size_t sites) {
    reserve_large(m_scratch.gradients, gradient_count(sites));
}

void EdgeMaker::begin(const Lattice& lattice, const Rect& part, bool bend, const float* gain,
                      float tau, Net& net) {
    m_lattice = &lattice;
    m_net = &net;
    m_part = part;
    m_bend = bend;
    m_gain = gain;
    m_reciprocal_tau = 1.0f / tau;
    m_gradient_rows = part.y0;
    m_edge_rows = 2 * part.y0;
    const auto width = size_t(lattice.width());
    if (gain) {
        net.soft.resize(lattice.size() * group_size);
        m_scratch.weights.resize(2 * width);
    }
    if (!bend)
        return;
    // A last row has no odd row after it, where its gradients' y would be.
    m_scratch.gradients.resize(gradient_count(lattice.size() + 2 * width));
    for (auto& row : m_scratch.vertices)
        row.resize(width * group_size + padding);
    for (CellRow& row : m_scratch.cells) {
        row.down.resize(width + padding);
        row.other.resize(width);
    }
}

void EdgeMaker::to_row(int y) {
    if (2 * y < m_edge_rows)
        return;
    const int last = std::min(y + rows_at_once, m_part.y1 - 1);
    if (m_bend) {
        const int end = std::min(last + m_lattice->longest(), m_part.y1);
        HWY_DYNAMIC_DISPATCH(make_gradients)
        (*m_lattice, m_part, m_gradient_rows, end, *m_net, m_scratch);
        m_gradient_rows = std::max(m_gradient_rows, end);
    }
    HWY_DYNAMIC_DISPATCH(make_edges)
    (*m_lattice, m_part, m_edge_rows, 2 * last + 1, m_bend, m_gain, m_reciprocal_tau, m_scratch,
     *m_net);
    m_edge_rows = 2 * last + 1;
}

} // namespace ddt
#endif
