// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: the surface at positions of crossed cells. A lane is
// first a triangle and then a position, of one channel; so all lanes are in use, however few
// positions a triangle has.
// Needs: <algorithm>, crossed_rows.h, crossed_cell-inl.h, triangle_numbers-inl.h.

/// Where positions lie in their cell, a lane each: all those of a cell, in some order, and after
/// them those of as many other cells as there is room for.
struct PositionLanes {
    static constexpr int most = 16;
    static_assert(most == 8 * sizeof(CellTriangle::positions), "a bit each");

    int count = 0; ///< of a cell's positions
    int cells = 0; ///< side by side
    float x[most] = {}, y[most] = {};
    int32_t bit[most] = {}; ///< cell k's begin at bit k * count

    int used() const { return cells * count; }

    /// Position order(i) of all is the cell's i-th.
    template <class Order>
    HWY_INLINE PositionLanes(const CellPositions& all, Order&& order) : count(all.count()) {
        cells = std::max(1, int(hn::Lanes(RowTag())) / count);
        for (int k = 0, lane = 0; k < cells; ++k)
            for (int i = 0; i < count; ++i, ++lane) {
                const int of = order(i);
                x[lane] = all.x()[of];
                y[lane] = all.y()[of];
                bit[lane] = 1 << (k * count + of);
            }
    }
};

/// Evaluates crossed cells of one row, where positions lie alike in all.
template <bool quadratic, bool soft>
class CrossedCells {
public:
    /// site: of the row's first corner, in column 0.
    HWY_INLINE CrossedCells(const ControlNet& net, int site, const PositionLanes& positions)
        : m_net(net), m_bounds(net.bounds), m_site(site), m_stride(net.stride),
          m_positions(positions) {}

    /// A channel's values at the positions, as PositionLanes has them.
    using Values = float[group_size][PositionLanes::most];

    /// Call use(first cell, how many, values) for neighbours among the cells.
    template <class Use>
    HWY_INLINE void each(const CrossedRows::Cell* cells, const CrossedRows::Cell* end,
                         const CellTriangle* triangles, Use&& use) {
        HWY_ALIGN Values f = {};
        while (cells < end) {
            const CrossedRows::Cell* const last = load(cells, end, triangles);
            for (const Group* g = m_groups; cells < last; cells += g->cells, ++g) {
                if (m_numbers.surely_finite())
                    evaluate<true>(*g, f);
                else
                    evaluate<false>(*g, f);
                use(cells, g->cells, f);
            }
        }
    }

private:
    /// Cells side by side.
    struct Group {
        int cells, first, triangles;
    };
    /// Triangles that each position is compared with, as long as they are there: usually as many
    /// as there are, or more.
    static constexpr int usual = hn::MaxLanes(RowTag()) < 6 ? hn::MaxLanes(RowTag()) : 6;

    /// Load as many cells' triangles as there is room for; returns where these cells end.
    HWY_INLINE const CrossedRows::Cell* load(const CrossedRows::Cell* cells,
                                             const CrossedRows::Cell* end,
                                             const CellTriangle* triangles) {
        // Branch-free for most cells: a loop over as many triangles as a cell has would be
        // mispredicted, so as many as usual are filled in at once.
        int32_t columns[TriangleNumbers::most + most_lanes] = {};
        int shifts[TriangleNumbers::most + usual];
        const CellTriangle* const first = triangles + cells->first;
        const int lanes = TriangleNumbers::lanes();
        int n = 0;
        Group* g = m_groups;
        *g = {0, 0, 0};
        for (; cells < end && n + cells->count <= TriangleNumbers::most; ++cells) {
            if (g->cells > 0 &&
                (g->cells == m_positions.cells || g->triangles + cells->count > lanes))
                *++g = {0, n, 0};
            const int shift = g->cells * m_positions.count;
            for (int i = 0; i < cells->count; i += usual) {
                std::fill_n(columns + n + i, usual, cells->x);
                std::fill_n(shifts + n + i, usual, shift);
            }
            n += cells->count;
            ++g->cells;
            g->triangles += cells->count;
        }
        for (int t = 0; t < n; ++t)
            m_bits[t] = int32_t(first[t].positions) << shifts[t];
        std::fill_n(m_bits + n, usual, 0);
        m_numbers.template load<quadratic, soft>(m_net, m_bounds, m_site, m_stride, first, columns,
                                                 n);
        return cells;
    }

    template <bool all_finite>
    HWY_INLINE void evaluate(const Group& group, Values& f) const {
        const RowTag d;
        const int lanes = TriangleNumbers::lanes();
        for (int at = 0; at < m_positions.used(); at += lanes) {
            const auto triangle = triangles_of(group, at);
            if (group.triangles <= lanes) {
                const auto index = hn::IndicesFromVec(d, triangle);
                evaluate<all_finite>(
                    group.first, at,
                    [&](const float* p)
                        HWY_ATTR { return RowLanes(hn::TableLookupLanes(hn::LoadU(d, p), index)); },
                    f);
            } else if (hn::MaxLanes(d) < PositionLanes::most) {
                evaluate<all_finite>(
                    group.first, at,
                    [&](const float* p)
                        HWY_ATTR { return RowLanes(hn::GatherIndex(d, p, triangle)); },
                    f);
            }
        }
    }

    /// Which of a group's triangles each position belongs to.
    HWY_INLINE hn::Vec<hn::RebindToSigned<RowTag>> triangles_of(const Group& group, int at) const {
        const hn::RebindToSigned<RowTag> di;
        const auto bit = hn::LoadU(di, m_positions.bit + at);
        auto triangle = hn::Zero(di);
        const auto choose = [&](int t) HWY_ATTR {
            const auto positions = hn::Set(di, m_bits[group.first + t]);
            triangle = hn::IfThenElse(hn::TestBit(positions, bit), hn::Set(di, t), triangle);
        };
        // Those of groups that follow may be among the first ones: the group's own, which have all
        // positions that are asked for, come last.
        for (int t = group.triangles - 1; t >= usual; --t)
            choose(t);
        for (int t = usual - 1; t >= 0; --t)
            choose(t);
        return triangle;
    }

    template <bool all_finite, class LookUp>
    HWY_INLINE void evaluate(int first, int at, LookUp&& look_up, Values& f) const {
        const auto planes = m_numbers.planes(first, look_up);
        const CrossingWeights<RowLanes> b(planes, RowLanes::load(m_positions.x + at),
                                          RowLanes::load(m_positions.y + at));
        for (int c = 0; c < int(m_net.count); ++c) {
            Patch<RowLanes> patch;
            m_numbers.template patch<quadratic, soft>(c, first, look_up, patch);
            patch.template at<quadratic, soft, all_finite>(b.b0, b.b1, b.b2).store(f[c] + at);
        }
    }

    const NetView m_net;
    const Bounds m_bounds;
    const int m_site, m_stride;
    const PositionLanes& m_positions;
    TriangleNumbers m_numbers;
    int32_t m_bits[TriangleNumbers::most + usual]; ///< the triangles' positions in their group
    Group m_groups[TriangleNumbers::most];
};
