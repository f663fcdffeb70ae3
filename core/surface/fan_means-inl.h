// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: mean gradients at vertices whose fans lie side by
// side, a block a vertex.
// Needs: edge_scratch.h, gradient-inl.h, blocks-inl.h.

/// n spokes of fans as numbers. row: floats of a row of pixels.
HWY_INLINE void load_spokes(const Vec* from, size_t n, int row, int count, Spokes& spokes) {
    const hn::RebindToSigned<D> di;
    const hn::Rebind<uint16_t, D> d16;
    const size_t lanes = hn::Lanes(di), size = n + most_lanes;
    if (spokes.x.size() < size) {
        spokes.x.resize(size);
        spokes.y.resize(size);
        spokes.at.resize(size);
    }
    for (size_t i = 0; i < n; i += lanes) {
        const auto both =
            hn::PromoteTo(di, hn::LoadU(d16, reinterpret_cast<const uint16_t*>(from + i)));
        const auto x = hn::ShiftRight<24>(hn::ShiftLeft<24>(both)),
                   y = hn::ShiftRight<24>(hn::ShiftLeft<16>(both));
        hn::StoreU(hn::ConvertTo(D(), x), D(), spokes.x.data() + i);
        hn::StoreU(hn::ConvertTo(D(), y), D(), spokes.y.data() + i);
        hn::StoreU(hn::Add(hn::Mul(y, hn::Set(di, row)), hn::Mul(x, hn::Set(di, count))), di,
                   spokes.at.data() + i);
    }
}

/// The mean gradients at a group's vertices from vertex i on, which add the same as a walk round
/// each. vertices: their row of the net, from column 0 on.
template <bool tame>
HWY_INLINE GradientMean<Blocks, tame> means_of_fans(const Fans::Group& group, int i,
                                                    const Spokes& spokes, const float* vertices,
                                                    int count) {
    const int blocks = blocks_in_vector();
    const float* vertex[most_blocks];
    for (int b = 0; b < blocks; ++b)
        vertex[b] = vertices + ptrdiff_t(group.x[i + b]) * count;
    const Blocks z = load_each(vertex);
    struct Neighbours {
        Blocks x, y, dz;
    };
    const auto neighbours = [&](int k) HWY_ATTR {
        const int first = k * fans_side_by_side + i;
        const float* at[most_blocks];
        for (int b = 0; b < blocks; ++b)
            at[b] = vertex[b] + spokes.at[size_t(first + b)];
        return Neighbours{spread(spokes.x.data() + first), spread(spokes.y.data() + first),
                          Blocks(load_each(at)) - z};
    };
    GradientMean<Blocks, tame> mean;
    Neighbours last = neighbours(0);
    const auto add = [&](int k) HWY_ATTR {
        const Neighbours next = neighbours(k);
        mean.add(last.x, last.y, next.x, next.y, last.dz, next.dz);
        last = next;
    };
    add(1);
    for (int k = 2; k <= group.least; ++k)
        add(k);
    if (group.least == group.most)
        return mean;
    // Those that have come round stay as they are.
    float degrees[most_lanes] = {};
    for (int b = 0; b < blocks; ++b)
        degrees[b] = float(group.degree[i + b]);
    const Blocks degree = spread(degrees);
    for (int k = group.least + 1; k <= group.most; ++k) {
        const GradientMean<Blocks, tame> before = mean;
        add(k);
        mean.keep_less(Blocks(float(k - 1)), degree, before);
    }
    return mean;
}
