// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: fitted bends of irregular edges (edge_kinds.h), one at
// a time.
// Needs: <algorithm>, <cstdlib>, fitted.h, features-inl.h, row_lanes-inl.h.

/// How nearly a flip of an edge would pay.
HWY_INLINE float nearness(const Edge& e, const FittedTable& table) {
    const float gain = e.gain(), loss = gain < 0.0f ? gain : 0.0f;
    const float t = 1.0f + loss * table.gain_scale;
    return t > 0.0f ? t : 0.0f;
}

/// The weights of an edge's null features, node after node.
struct NullWeights {
    static constexpr int count = fitted_nodes * fitted_edge_null;
    HWY_ALIGN float w[count];

    HWY_INLINE NullWeights(const Edge& e, const FittedTable& table) {
        const auto& kinds = table.null[fitted_length(e.v.x, e.v.y)];
        if (!e.flippable()) {
            std::copy_n(&kinds[0][0][0], count, w);
            return;
        }
        const PixelLanes near(nearness(e, table));
        for (int k = 0; k < fitted_nodes; ++k)
            (PixelLanes::load(kinds[1][k]) + near * PixelLanes::load(kinds[2][k]))
                .store(w + k * fitted_edge_null);
    }
};

/// Whether all pixels that the features of the edge with midpoint (mx, my), in doubled coordinates,
/// are made of lie within the picture.
HWY_INLINE bool reaches_inside(const Edge& e, int mx, int my, int width, int height) {
    const auto fits = [](int m, int v, int left, int right, int size) {
        const int along = std::abs(v), aside = std::max(std::abs(left), std::abs(right));
        const int far = std::max(5 * along, 3 * aside + 2 * along);
        return m >= far && m + far <= 2 * (size - 1);
    };
    const Vec right = e.right();
    return fits(mx, e.v.x, e.left.x, right.x, width) && fits(my, e.v.y, e.left.y, right.y, height);
}

class IrregularBends {
public:
    HWY_INLINE IrregularBends(const FittedSource& source, const IndexRows& index,
                              const ControlNet& plain, ControlNet& net)
        : m_source(source), m_index(index), m_plain(plain), m_net(net) {}

    /// Bend the edge with this midpoint.
    HWY_INLINE void bend(int mx, int my) const {
        const FittedTable& table = fitted_table();
        const Lattice& lattice = m_source.lattice;
        const int width = lattice.width(), height = lattice.height(), count = m_source.count;
        const int m = lattice.site(mx, my);
        const Edge& edge = lattice.edge(m);
        // A missing apex mirrors the other.
        const Vec right = edge.right(), v = edge.v, l = edge.left.zero() ? -right : edge.left,
                  r = right.zero() ? -edge.left : right;
        const Place a{(mx - v.x) / 2, (my - v.y) / 2};
        const PixelLanes plain = PixelLanes::load(m_plain.at(m));
        EdgeFeatures<PixelLanes> f;
        if (reaches_inside(edge, mx, my, width, height)) {
            const ptrdiff_t row = ptrdiff_t(width) * count;
            const auto address = [&](int x, int y) { return y * row + ptrdiff_t(x) * count; };
            const auto tap = [&](ptrdiff_t at)
                                 HWY_ATTR { return PixelLanes::load(m_source.pixels + at); };
            f.find(address(a.x, a.y), address(v.x, v.y), address(l.x, l.y), address(r.x, r.y),
                   plain, tap);
        } else {
            const auto inside = [&](int x, int y)
                                    HWY_ATTR { return PixelLanes::load(m_source.at(x, y)); };
            const auto tap = [&](Place p) HWY_ATTR {
                return odd_mirror_tap<PixelLanes>(p.x, p.y, width, height, inside);
            };
            f.find(a, {v.x, v.y}, {l.x, l.y}, {r.x, r.y}, plain, tap);
        }
        const PixelLanes mean = (PixelLanes::load(m_index.at(a.x, a.y)) +
                                 PixelLanes::load(m_index.at(a.x + v.x, a.y + v.y))) *
                                PixelLanes(0.5f);
        const NullWeights weights(edge, table);
        const auto null = [&](int k, int i)
                              HWY_ATTR { return PixelLanes(weights.w[k * fitted_edge_null + i]); };
        store_pixel(fitted_bend(f, mean, null, table), count, m_net.at(m));
    }

private:
    const FittedSource& m_source;
    const IndexRows& m_index;
    const ControlNet& m_plain;
    ControlNet& m_net;
};
