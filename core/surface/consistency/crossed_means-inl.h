// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: the means of the quadrants of crossed cells.
// Needs: consistency.h, blocks-inl.h, crossed_cells-inl.h.

/// Of lane `lane`, which of all positions of means it is: the quadrants' first ones, their second
/// ones, and so on, in the order back and forth through all positions.
HWY_INLINE int mean_position(int lane) {
    const int quadrant = lane % 4, turn = lane / 4;
    const int right = 2 * (quadrant & 1) + (turn == 1 || turn == 2),
              below = (quadrant & 2) + (turn >= 2);
    return below * quadrant_side + right;
}

/// Finds the means of the crossed cells of one row.
template <bool quadratic, bool soft>
class CrossedMeans {
public:
    /// means: of column 0, `row` floats from one quadrant's to the next.
    HWY_INLINE CrossedMeans(const Lattice& lattice, const ControlNet& net, int y, float* means,
                            size_t row)
        : m_net(net), m_site(lattice.vertex_site(0, y)), m_means(means), m_row(row),
          m_positions(mean_positions(), mean_position), m_cells(net, m_site, m_positions) {
        static_assert(quadrant_side * quadrant_side == PositionLanes::most, "one cell at a time");
    }

    HWY_INLINE void find(const CrossedRows::Cell* cells, const CrossedRows::Cell* end,
                         const CellTriangle* triangles) {
        m_cells.each(cells, end, triangles,
                     [&](const CrossedRows::Cell* cell, int, const Values& f)
                         HWY_ATTR { store(cell->x, f); });
    }

private:
    using Values = typename CrossedCells<quadratic, soft>::Values;

    HWY_INLINE void store(int x, const Values& f) const {
        using Quadrants = PixelLanes;
        const CellNumbers values(m_net, m_net.values, m_site + 2 * x);
        PixelLanes pixels[group_size];
        for (int k = 0; k < 4; ++k)
            pixels[k] = PixelLanes::load(values.corner(0, k & 1, k >> 1));
        Quadrants z[group_size], mean[group_size];
        transpose(pixels, z);
        for (int c = 0; c < group_size; ++c) {
            mean[c] = Quadrants(0.0f);
            if (c >= int(m_net.count))
                continue;
            for (int turn = 0; turn < 4; ++turn)
                mean[c] = mean[c] + (Quadrants::load(f[c] + 4 * turn) - z[c]);
            mean[c] = mean[c] * Quadrants(0.25f);
        }
        transpose(mean, pixels);
        for (int k = 0; k < 4; ++k)
            store_pixel(pixels[k], int(m_net.count),
                        m_means + size_t(k) * m_row + ptrdiff_t(x) * m_net.count);
    }

    const NetView m_net;
    const int m_site;
    float* const m_means;
    const size_t m_row;
    const PositionLanes m_positions;
    CrossedCells<quadratic, soft> m_cells;
};
