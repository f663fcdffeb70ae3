// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: irregular edges (edge_kinds.h), a block an edge.
// Needs: <algorithm>, gradient-inl.h, blocks-inl.h, row_lanes-inl.h, site_lanes-inl.h.

/// Of as many edges of a row as there are lanes: how many floats from the row's first vertex their
/// ends i and j, and if `soft` their apexes c and d, are, and from the row's first edge they
/// themselves; and what else they are made from.
template <bool soft>
struct EdgeList {
    HWY_ALIGN int32_t i[most_lanes], j[most_lanes], c[most_lanes], d[most_lanes], at[most_lanes];
    // Padded for spread().
    float vx[2 * most_lanes], vy[2 * most_lanes], weight[2 * most_lanes];

    /// to_first: from the row's first vertex to the edge in column 0, in sites. weights: from
    /// column 0 on.
    HWY_INLINE void load(const SiteLanes& lattice, int row, int to_first, const int* columns,
                         const float* weights, int count) {
        const DI di;
        const VI x = hn::LoadU(di, columns);
        const Ints place{hn::Add(hn::ShiftLeft<1>(x), hn::Set(di, to_first))};
        const EdgeLanes edge = lattice.edge(Ints{hn::Set(di, row)} + place);
        const auto store = [&](Ints site, int32_t* to) HWY_ATTR {
            hn::StoreU(hn::Mul(hn::ShiftRight<1>(site.i), hn::Set(di, count)), di, to);
        };
        const Ints to_j = lattice.offset(edge.v);
        store(place - to_j, i);
        store(place + to_j, j);
        lattice.x(edge.v).store(vx);
        lattice.y(edge.v).store(vy);
        if (soft) {
            store(place + lattice.offset(edge.left), c);
            store(place + lattice.offset(edge.right), d);
            store(Ints{hn::ShiftLeft<1>(x)}, at);
            hn::StoreU(hn::GatherIndex(D(), weights, x), D(), weight);
        }
    }
};

/// The numbers at some of a list's places, a block each.
HWY_INLINE Blocks at_each(const float* row, const int32_t* places) {
    const float* p[most_lanes / group_size];
    for (int b = 0; b < blocks_in_vector(); ++b)
        p[b] = row + places[b];
    return load_each(p);
}

HWY_INLINE void store_each(Blocks numbers, const int* columns, int count, float* row) {
    HWY_ALIGN float all[most_lanes];
    numbers.store(all);
    for (int b = 0; b < blocks_in_vector(); ++b)
        store_pixel(PixelLanes::load(all + b * group_size), count,
                    row + ptrdiff_t(columns[b]) * count);
}

/// What irregular edges of a row are made from: of each, what lies at the row's first vertex and
/// beyond.
struct IrregularEdges {
    const float *vertices, *gradients;
    ptrdiff_t to_y; ///< from a gradient's x to its y
    int row;        ///< the site of the row's first vertex
    int to_first;   ///< from there to the edge in column 0, in sites
    const float* weights;
    const float* bends; ///< without `bend`: e from column 0 on; null: 0
    Bounds bounds;      ///< ControlNet::bounds
    int count;
};

/// e, if `bend`, and q, if `soft`, of the edges in n columns; what follows these, as many as a
/// vector has lanes, may be any of them. e, q: from column 0 on. Compiled once for all kinds.
template <bool bend, bool soft>
HWY_NOINLINE void make_irregular(const SiteLanes& lattice, const IrregularEdges& from,
                                 const int* columns, int n, float* e, float* q) {
    const int lanes = int(hn::Lanes(D())), blocks = blocks_in_vector();
    EdgeList<soft> list;
    for (int done = 0; done < n; done += lanes) {
        list.load(lattice, from.row, from.to_first, columns + done, from.weights, from.count);
        for (int k = 0; k < std::min(lanes, n - done); k += blocks) {
            const auto at = [&](const float* row, const int32_t* places)
                                HWY_ATTR { return at_each(row, places + k); };
            const Blocks zi = at(from.vertices, list.i), zj = at(from.vertices, list.j);
            Blocks bent(0.0f);
            // Where an end lies outside the part its gradient is not known, and e is never used.
            if (bend) {
                const float *gx = from.gradients, *gy = gx + from.to_y;
                bent =
                    edge_bend<false>(at(gx, list.i), at(gy, list.i), at(gx, list.j), at(gy, list.j),
                                     zi, zj, spread(list.vx + k), spread(list.vy + k));
                store_each(bent, columns + done + k, from.count, e);
            } else if (from.bends) {
                bent = at(from.bends, list.at);
            }
            // An edge that cannot be flipped has weight 0; its apexes are read all the same, if
            // they are no vertices, too: never tame.
            if (soft)
                store_each(edge_softness<false>(spread(list.weight + k), zi, zj,
                                                at(from.vertices, list.c),
                                                at(from.vertices, list.d), bent, from.bounds),
                           columns + done + k, from.count, q);
        }
    }
}
