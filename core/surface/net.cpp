#include "core/surface/net.h"

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <cstring>

#include "core/arith/arith.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/net.cpp"
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

/// Weight of the flipped state of a flippable edge with this gain (see net.h), 0 to 1/2.
HWY_INLINE float soft_weight(float gain, float reciprocal_tau) {
    const float loss = gain < 0.0f ? gain : 0.0f;
    const float w = 1.0f + loss * reciprocal_tau;
    return w > 0.0f ? 0.5f * w : 0.0f;
}

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
using D2 = hn::CappedTag<float, 2 * group_size>;
using Blocks = Lanes<D2>;

/// The numbers at vertices next to one another, the first at p.
HWY_INLINE Blocks load_vertices(const float* p) {
    const D2 d;
    if (hn::Lanes(d) == group_size)
        return hn::LoadU(d, p);
    return hn::ConcatLowerLower(d, hn::LoadU(d, p + 2 * group_size), hn::LoadU(d, p));
}

/// A block of ones for every bit that is set.
HWY_INLINE Blocks flags(unsigned bits) {
    HWY_ALIGN static constexpr float table[4][2 * group_size] = {
        {0, 0, 0, 0, 0, 0, 0, 0},
        {1, 1, 1, 1, 0, 0, 0, 0},
        {0, 0, 0, 0, 1, 1, 1, 1},
        {1, 1, 1, 1, 1, 1, 1, 1},
    };
    return Blocks::load(table[bits]);
}

/// How the cells round a row of vertices are divided, as Division.
struct CellRows {
    const Division *above, *below; ///< [x]: the cell to the right of vertex x
    bool plain(int x) const {
        return above[x - 1] != Division::other && above[x] != Division::other &&
               below[x - 1] != Division::other && below[x] != Division::other;
    }
};

/// Gradients at plain vertices x, x + 1, ... of as many as Blocks has; s is the site of the first.
HWY_INLINE void plain_gradients(const CellRows& cells, int x, const Net& net, int s, float* out) {
    const D2 d;
    unsigned nw = 0, ne = 0, se = 0, sw = 0;
    for (unsigned k = 0; k < hn::Lanes(d) / group_size; ++k) {
        const int at = x + int(k);
        nw |= unsigned(cells.above[at - 1] == Division::down) << k;
        ne |= unsigned(cells.above[at] == Division::up) << k;
        se |= unsigned(cells.below[at] == Division::down) << k;
        sw |= unsigned(cells.below[at - 1] == Division::up) << k;
    }
    const float* p = net.at(s);
    const ptrdiff_t side = 2 * group_size, down = side * net.stride;
    const Blocks z = load_vertices(p);
    const auto difference = [&](ptrdiff_t to) HWY_ATTR { return load_vertices(p + to) - z; };
    Differences<Blocks> differences;
    differences.nw = difference(-down - side);
    differences.n = difference(-down);
    differences.ne = difference(-down + side);
    differences.e = difference(side);
    differences.se = difference(down + side);
    differences.s = difference(down);
    differences.sw = difference(down - side);
    differences.w = difference(-side);
    Blocks gx, gy;
    plain_mean(differences, flags(nw), flags(ne), flags(se), flags(sw)).result(gx, gy);
    float* to = out + size_t(s) * group_size;
    if (hn::Lanes(d) == group_size) {
        gx.store(to);
        gy.store(to + group_size);
    } else {
        hn::StoreU(hn::ConcatLowerLower(d, gy.v, gx.v), d, to);
        hn::StoreU(hn::ConcatUpperUpper(d, gy.v, gx.v), d, to + 2 * group_size);
    }
}

HWY_ATTR void make_gradients(const Lattice& lattice, const Rect& part, const Net& net,
                             Gradients& gradients) {
    const int stride = lattice.stride(), cells = lattice.width() - 1;
    float* out = gradients.xy.data();
    const auto divide = [&](int y, std::vector<Division>& row) {
        row.resize(size_t(cells));
        const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1, cells);
        for (int x = begin; x < end; ++x)
            row[size_t(x)] = division(lattice.edge(lattice.site(2 * x + 1, 2 * y + 1)));
    };
    auto &above = gradients.above, &below = gradients.below;
    if (part.y0 > 0)
        divide(part.y0 - 1, below);
    const int step = int(hn::Lanes(D2())) / group_size;
    for (int y = part.y0; y < part.y1; ++y) {
        above.swap(below);
        const bool inner = y > 0 && y < lattice.height() - 1;
        if (y < lattice.height() - 1)
            divide(y, below);
        const CellRows rows{above.data(), below.data()};
        const auto plain = [&](int x) { return inner && x > 0 && x < cells && rows.plain(x); };
        for (int x = part.x0; x < part.x1;) {
            const int s = lattice.vertex_site(x, y);
            if (x + step <= part.x1 && plain(x) && plain(x + step - 1)) {
                plain_gradients(rows, x, net, s, out);
                x += step;
                continue;
            }
            const auto mean = mean_round(lattice.sites() + s, net.at(s), stride);
            Lanes4 gx, gy;
            mean.result(gx, gy);
            gx.store(out + size_t(s) * group_size);
            gy.store(out + size_t(s + 1) * group_size);
            ++x;
        }
    }
}

HWY_ATTR void make_edges(const Lattice& lattice, const Rect& part, const float* gradients,
                         Net& net) {
    const int stride = lattice.stride();
    for (int y = 2 * part.y0; y < 2 * part.y1 - 1; ++y) {
        const int odd = y & 1;
        int m = lattice.site(2 * part.x0 + 1 - odd, y);
        const int end = lattice.site(2 * part.x1 - 1, y);
        for (; m < end; m += 2 - odd) {
            const Vec v = lattice.sites()[m].edge.v;
            const ptrdiff_t to_j = group_size * ptrdiff_t(v.y * stride + v.x);
            float* e = net.at(m);
            // Where an end lies outside the part its gradient is not known, and e is never used.
            const float* g = gradients + size_t(m) * group_size;
            const float *gi = g - to_j, *gj = g + to_j;
            edge_bend(Lanes4::load(gi), Lanes4::load(gi + group_size), Lanes4::load(gj),
                      Lanes4::load(gj + group_size), Lanes4::load(e - to_j), Lanes4::load(e + to_j),
                      Lanes4(float(v.x)), Lanes4(float(v.y)))
                .store(e);
        }
    }
}

HWY_ATTR void make_soft(const Lattice& lattice, const Rect& part, const float* gain,
                        float reciprocal_tau, Net& net) {
    const int stride = lattice.stride();
    for (int y = 2 * part.y0; y < 2 * part.y1 - 1; ++y) {
        const int odd = y & 1;
        int m = lattice.site(2 * part.x0 + 1 - odd, y);
        const int end = lattice.site(2 * part.x1 - 1, y);
        for (; m < end; m += 2 - odd) {
            float* q = net.soft.data() + size_t(m) * group_size;
            const Edge& e = lattice.edge(m);
            const float w = e.flippable() ? soft_weight(gain[m], reciprocal_tau) : 0.0f;
            if (w == 0.0f) {
                Lanes4(0.0f).store(q);
                continue;
            }
            const ptrdiff_t to_j = group_size * ptrdiff_t(e.v.y * stride + e.v.x);
            const ptrdiff_t to_c = group_size * ptrdiff_t(e.left.y * stride + e.left.x);
            const float* z = net.at(m);
            edge_softness(Lanes4(w), Lanes4::load(z - to_j), Lanes4::load(z + to_j),
                          Lanes4::load(z + to_c), Lanes4::load(z - to_c))
                .store(q);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_gradients);
HWY_EXPORT(make_edges);
HWY_EXPORT(make_soft);

void set_vertices(const Lattice& lattice, const float* values, int channels, int first, int count,
                  Net& net) {
    net.values.resize(lattice.size() * group_size);
    net.stride = lattice.stride();
    for (int y = 0; y < lattice.height(); ++y) {
        float* z = net.at(lattice.vertex_site(0, y));
        for (int x = 0; x < lattice.width(); ++x, values += channels, z += 2 * group_size)
            for (int c = 0; c < group_size; ++c)
                z[c] = c < count ? values[first + c] : 0.0f;
    }
}

void bend_edges(const Lattice& lattice, const Rect& part, Net& net, Gradients& gradients) {
    gradients.xy.resize((lattice.size() + 1) * group_size);
    HWY_DYNAMIC_DISPATCH(make_gradients)(lattice, part, net, gradients);
    HWY_DYNAMIC_DISPATCH(make_edges)(lattice, part, gradients.xy.data(), net);
}

void soften_edges(const Lattice& lattice, const Rect& part, const float* gain, float tau,
                  Net& net) {
    net.soft.resize(lattice.size() * group_size);
    HWY_DYNAMIC_DISPATCH(make_soft)(lattice, part, gain, 1.0f / tau, net);
}

} // namespace ddt
#endif
