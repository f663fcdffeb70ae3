#include "core/surface/net.h"

#include <cfloat>

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

/// Walk round the vertex at site s and call f(j, k, zj - z, zk - z) for each of its triangles: j, k
/// the other vertices relative to it in pixels, det(j, k) = 1. In a fixed order: from the first
/// edge to the left, and at the hull's rim from the first edge to the right.
template <class F>
HWY_INLINE void each_triangle_round(const Lattice& lattice, const Net& net, int s, F&& f) {
    const Vec first = lattice.vertex(s).first;
    const auto apex = [&](Vec r, bool left) HWY_ATTR {
        const Edge& e = lattice.edge(s + lattice.offset(r));
        return (e.v == r) == left ? e.left : e.right;
    };
    const Lanes4 z = Lanes4::load(net.at(s));
    const auto difference = [&](Vec r) HWY_ATTR {
        return Lanes4::load(net.at(s + 2 * lattice.offset(r))) - z;
    };
    const Lanes4 dz_first = difference(first);
    Vec r = first;
    Lanes4 dz = dz_first;
    for (;;) {
        const Vec a = apex(r, true);
        if (a.zero())
            break;
        const Vec next((r.x + a.x) / 2, (r.y + a.y) / 2);
        const Lanes4 dz_next = difference(next);
        f(r, next, dz, dz_next);
        if (next == first)
            return;
        r = next;
        dz = dz_next;
    }
    r = first;
    dz = dz_first;
    for (;;) {
        const Vec a = apex(r, false);
        if (a.zero())
            return;
        const Vec next((r.x + a.x) / 2, (r.y + a.y) / 2);
        const Lanes4 dz_next = difference(next);
        f(next, r, dz_next, dz);
        r = next;
        dz = dz_next;
    }
}

HWY_ATTR void make_gradients(const Lattice& lattice, const Net& net, Gradients& gradients) {
    const int width = lattice.width(), height = lattice.height();
    float* out = gradients.xy.data();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, out += 2 * group_size) {
            GradientMean<Lanes4> mean;
            each_triangle_round(lattice, net, lattice.vertex_site(x, y),
                                [&](Vec j, Vec k, Lanes4 dzj, Lanes4 dzk)
                                    HWY_ATTR { mean.add(j.x, j.y, k.x, k.y, dzj, dzk); });
            Lanes4 gx, gy;
            mean.result(gx, gy);
            gx.store(out);
            gy.store(out + group_size);
        }
}

HWY_ATTR void make_edges(const Lattice& lattice, const Gradients& gradients, Net& net) {
    const int width = lattice.width();
    const auto gradient = [&](int doubled_x, int doubled_y) {
        return gradients.xy.data() +
               (size_t(doubled_y / 2) * size_t(width) + size_t(doubled_x / 2)) * (2 * group_size);
    };
    for (int y = 0; y < 2 * lattice.height() - 1; ++y)
        for (int x = 1 - (y & 1), step = 2 - (y & 1); x < 2 * width - 1; x += step) {
            const int m = lattice.site(x, y);
            const Vec v = lattice.edge(m).v;
            const float* gi = gradient(x - v.x, y - v.y);
            const float* gj = gradient(x + v.x, y + v.y);
            edge_bend(Lanes4::load(gi), Lanes4::load(gi + group_size), Lanes4::load(gj),
                      Lanes4::load(gj + group_size), Lanes4::load(net.at(m - lattice.offset(v))),
                      Lanes4::load(net.at(m + lattice.offset(v))), v.x, v.y)
                .store(net.at(m));
        }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_gradients);
HWY_EXPORT(make_edges);

void make_net(const Lattice& lattice, Surface surface, const float* values, int channels, int first,
              int count, Net& net, Gradients& gradients) {
    net.values.resize(lattice.size() * group_size);
    net.stride = lattice.stride();
    const int width = lattice.width(), height = lattice.height();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* in =
                values + (size_t(y) * size_t(width) + size_t(x)) * size_t(channels) + first;
            float* z = net.at(lattice.vertex_site(x, y));
            for (int c = 0; c < group_size; ++c)
                z[c] = c < count ? in[c] : 0.0f;
        }
    if (surface == Surface::linear)
        return;
    gradients.xy.resize(size_t(width) * size_t(height) * 2 * group_size);
    HWY_DYNAMIC_DISPATCH(make_gradients)(lattice, net, gradients);
    HWY_DYNAMIC_DISPATCH(make_edges)(lattice, gradients, net);
}

} // namespace ddt
#endif
