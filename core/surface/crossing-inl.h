// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: the surface at positions in a crossed cell.
// Needs: crossed_cell.h, control_net.h, crossed_cell-inl.h, patch-inl.h, blocks-inl.h.

/// The blocks whose bits are set.
HWY_INLINE hn::Mask<D> blocks_of(unsigned bits) {
    const hn::RebindToSigned<D> di;
    const auto block = hn::ShiftRight<2>(hn::Iota(di, 0));
    const auto bit = hn::Shl(hn::Set(di, 1), block);
    return hn::RebindMask(D(), hn::TestBit(hn::Set(di, int32_t(bits)), bit));
}

/// What the net has of a triangle, in every block.
template <bool quadratic, bool soft>
HWY_INLINE void load_patch(const NetView& net, const int vertex[3], const int edge[3],
                           Patch<Blocks>& patch) {
    patch.template load<quadratic, soft>(
        vertex, edge, [&](int s) HWY_ATTR { return in_every_block(net.vertex(s)); },
        [&](int s) HWY_ATTR { return in_every_block(net.at(s)); },
        [&](int s) HWY_ATTR { return in_every_block(net.soft_at(s)); });
}

template <bool quadratic, bool soft, bool all_finite>
HWY_INLINE void evaluate_positions(const Patch<Blocks>& patch, const CrossingTriangle& triangle,
                                   const CellPositions& positions, float* f) {
    const int step = blocks_in_vector();
    for (int i = 0; i < positions.count(); i += step) {
        const unsigned bits = unsigned(triangle.positions >> i) & ((1u << step) - 1);
        if (!bits)
            continue;
        const CrossingWeights<Blocks> b(triangle.planes, spread(positions.x() + i),
                                        spread(positions.y() + i));
        const Blocks value = patch.template at<quadratic, soft, all_finite>(b.b0, b.b1, b.b2);
        hn::BlendedStore(value.v, blocks_of(bits), D(), f + i * group_size);
    }
}

/// The surface over a triangle at the positions that belong to it: f + i * group_size, with room
/// for whole vectors. bounds: see Patch::find_range().
template <bool quadratic, bool soft>
HWY_INLINE void evaluate_crossing(const NetView& net, Bounds bounds,
                                  const CrossingTriangle& triangle, const CellPositions& positions,
                                  float* f) {
    const int edge[3] = {triangle.edge(0), triangle.edge(1), triangle.edge(2)};
    Patch<Blocks> patch;
    load_patch<quadratic, soft>(net, triangle.vertex, edge, patch);
    if (patch.is_surely_finite()) {
        patch.template find_range<true>(bounds);
        evaluate_positions<quadratic, soft, true>(patch, triangle, positions, f);
    } else {
        patch.template find_range<false>(bounds);
        evaluate_positions<quadratic, soft, false>(patch, triangle, positions, f);
    }
}
