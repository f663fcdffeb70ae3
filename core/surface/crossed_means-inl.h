// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace, after patch-inl.h, crossed_cell-inl.h,
// consistency-inl.h, row_lanes-inl.h and crossed_rows.h: the means of the quadrants of cells that
// other edges cross. A lane is first a triangle and then a position, of one channel; so all lanes
// are in use, however few positions a triangle has.

/// What triangles have, a number each.
class TriangleNumbers {
public:
    static constexpr int most = 32;

    /// Of n triangles, at most so many, of cells in these columns of the row with its first corner
    /// at this site.
    template <bool quadratic, bool soft>
    HWY_INLINE void load(const NetView& net, const float* strict, int site, int stride,
                         const CellTriangle* triangles, const int32_t* columns, int n) {
        static_assert(sizeof(CellTriangle) == 2 * sizeof(int32_t), "two words");
        std::memcpy(m_words, triangles, size_t(n) * sizeof(CellTriangle));
        for (int i = 0; i < n; i += lanes())
            place(i, columns + i, stride, int(net.count));
        copy<quadratic, soft>(net, net.place(site), n);
        m_tame = true;
        for (int i = 0; i < n; i += lanes())
            separate<quadratic, soft>(int(net.count), i, n);
        for (int c = 0; c < int(net.count); ++c)
            for (int i = 0; i < n; i += lanes()) {
                if (m_tame)
                    find_range<soft, true>(c, strict[c], i);
                else
                    find_range<soft, false>(c, strict[c], i);
            }
    }

    bool tame() const { return m_tame; }
    /// A bit for each position, a lane, that belongs to triangle i.
    uint32_t positions(int i) const { return uint32_t(m_words[2 * i + 1]) >> 16; }

    struct Planes {
        RowLanes across[2][2], offset[2];
    };
    /// look_up: a function from where the first triangle's number is to each lane's.
    template <class LookUp>
    HWY_INLINE Planes planes(int first, LookUp&& look_up) const {
        Planes p;
        for (int k = 0; k < 2; ++k) {
            p.across[k][0] = look_up(m_planes[3 * k] + first);
            p.across[k][1] = look_up(m_planes[3 * k + 1] + first);
            p.offset[k] = look_up(m_planes[3 * k + 2] + first);
        }
        return p;
    }
    template <bool quadratic, bool soft, class LookUp>
    HWY_INLINE void patch(int channel, int first, LookUp&& look_up, Patch<RowLanes>& p) const {
        const auto number = [&](int k) HWY_ATTR { return look_up(m_numbers[channel][k] + first); };
        p.z0 = number(z), p.z1 = number(z + 1), p.z2 = number(z + 2);
        if (quadratic)
            p.e01 = number(e), p.e12 = number(e + 1), p.e20 = number(e + 2);
        if (soft)
            p.q01 = number(q), p.q12 = number(q + 1), p.q20 = number(q + 2);
        p.low = number(low), p.high = number(high);
    }

    static HWY_INLINE int lanes() { return int(hn::Lanes(RowTag())); }

private:
    enum { z = 0, e = 3, q = 6, low = 9, high = 10, all = 11 };
    static constexpr int room = most + most_row_lanes;
    using IntTag = hn::RebindToSigned<RowTag>;

    /// Byte k of each lane as a signed number.
    template <int k>
    static HWY_INLINE hn::Vec<IntTag> signed_byte(hn::Vec<IntTag> x) {
        return hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * k>(x));
    }

    /// Where what the net has of triangles i, i + 1, ... is, and their planes, as CrossingTriangle
    /// has them.
    HWY_INLINE void place(int i, const int32_t* columns, int stride, int count) {
        const RowTag d;
        const IntTag di;
        hn::Vec<IntTag> first, second;
        hn::LoadInterleaved2(di, m_words + 2 * i, first, second);
        const hn::Vec<IntTag> x[3] = {signed_byte<0>(first), signed_byte<2>(first),
                                      signed_byte<0>(second)},
                              y[3] = {signed_byte<1>(first), signed_byte<3>(first),
                                      signed_byte<1>(second)};
        const auto column = hn::LoadU(di, columns), floats = hn::Set(di, count);
        hn::Vec<IntTag> vertex[3];
        for (int k = 0; k < 3; ++k) {
            vertex[k] = hn::Add(hn::Mul(y[k], hn::Set(di, stride)), hn::Add(x[k], column));
            hn::StoreU(hn::Mul(vertex[k], floats), di, m_vertex[k] + i);
        }
        for (int k = 0; k < 3; ++k) {
            const auto edge = hn::Add(vertex[k], vertex[(k + 1) % 3]);
            hn::StoreU(hn::Mul(hn::ShiftRight<1>(edge), floats), di, m_edge[k] + i);
            hn::StoreU(hn::And(edge, hn::Set(di, 1)), di, m_odd[k] + i);
        }
        for (int k = 0; k < 2; ++k) {
            const int from = k + 1, to = (k + 2) % 3;
            const auto dx = hn::Sub(x[to], x[from]), dy = hn::Sub(y[to], y[from]);
            const auto offset = hn::Sub(hn::Mul(dy, x[from]), hn::Mul(dx, y[from]));
            hn::StoreU(hn::ConvertTo(d, dx), d, m_planes[3 * k] + i);
            hn::StoreU(hn::ConvertTo(d, dy), d, m_planes[3 * k + 1] + i);
            hn::StoreU(hn::ConvertTo(d, offset), d, m_planes[3 * k + 2] + i);
        }
    }

    /// Copy what the net has of the triangles; from: where the row is.
    template <bool quadratic, bool soft>
    HWY_INLINE void copy(const NetView& net, ptrdiff_t from, int n) {
        const float* const vertices = net.values.even + from;
        const float* const bends[] = {vertices, net.values.odd + from};
        const float* softness[2] = {};
        if (soft)
            softness[0] = net.soft.even + from, softness[1] = net.soft.odd + from;
        for (int t = 0; t < n; ++t) {
            const auto put = [&](int k, const float* p) HWY_ATTR {
                PixelLanes::load(p).store(m_pixels[k] + t * group_size);
            };
            for (int k = 0; k < 3; ++k) {
                put(z + k, vertices + m_vertex[k][t]);
                const int odd = m_odd[k][t];
                if (quadratic)
                    put(e + k, bends[odd] + m_edge[k][t]);
                if (soft)
                    put(q + k, softness[odd] + m_edge[k][t]);
            }
        }
    }

    /// The channels of triangles i, i + 1, ..., each by itself.
    template <bool quadratic, bool soft>
    HWY_INLINE void separate(int count, int i, int n) {
        const RowTag d;
        RowLanes size[group_size];
        for (int k = 0; k < low; ++k) {
            if ((!quadratic && e <= k && k < q) || (!soft && q <= k))
                continue;
            hn::Vec<RowTag> channel[group_size];
            hn::LoadInterleaved4(d, m_pixels[k] + i * group_size, channel[0], channel[1],
                                 channel[2], channel[3]);
            for (int c = 0; c < count; ++c) {
                hn::StoreU(channel[c], d, m_numbers[c][k] + i);
                if (k == z)
                    size[c] = size_of(RowLanes(channel[c]));
                else if (k < e)
                    size[c] = size[c] + size_of(RowLanes(channel[c]));
            }
        }
        const auto here = hn::FirstN(d, size_t(std::min(n - i, lanes())));
        for (int c = 0; c < count; ++c)
            m_tame &= RowLanes::all_within(Patch<RowLanes>::tame_size,
                                           hn::IfThenElseZero(here, size[c].v));
    }

    template <bool soft, bool tame>
    HWY_INLINE void find_range(int c, float strict, int i) {
        float(*numbers)[room] = m_numbers[c];
        Patch<RowLanes> p;
        p.z0 = RowLanes::load(numbers[z] + i), p.z1 = RowLanes::load(numbers[z + 1] + i);
        p.z2 = RowLanes::load(numbers[z + 2] + i);
        p.template find_range<soft, tame>(RowLanes(strict), false);
        p.low.store(numbers[low] + i);
        p.high.store(numbers[high] + i);
    }

    bool m_tame = false;
    int32_t m_words[2 * room]; ///< the triangles, as they are kept
    /// In floats from the row's first, in even or odd columns.
    int32_t m_vertex[3][room], m_edge[3][room], m_odd[3][room];
    float m_planes[6][room];
    float m_pixels[low][room * group_size]; ///< as they are in the net
    float m_numbers[group_size][all][room];
};

/// The positions of means in the lanes: the quadrants' first ones, their second ones, and so on, in
/// the order back and forth through all positions.
struct MeanLanes {
    static constexpr int count = quadrant_side * quadrant_side;
    float x[count], y[count];
    int32_t bit[count];

    HWY_INLINE MeanLanes() {
        const CellPositions& all = mean_positions();
        for (int lane = 0; lane < count; ++lane) {
            const int quadrant = lane % 4, turn = lane / 4;
            const int right = 2 * (quadrant & 1) + (turn == 1 || turn == 2),
                      below = (quadrant & 2) + (turn >= 2);
            const int i = below * quadrant_side + right;
            x[lane] = all.x()[i];
            y[lane] = all.y()[i];
            bit[lane] = 1 << i;
        }
    }
};

/// Finds the means of the crossed cells of one row.
template <bool quadratic, bool soft>
class CrossedMeans {
public:
    /// means: of column 0, `row` floats from one quadrant's to the next.
    HWY_INLINE CrossedMeans(const Lattice& lattice, const Net& net, int y, float* means, size_t row)
        : m_lattice(lattice), m_net(net), m_strict(net.strict), m_y(y), m_means(means), m_row(row) {
    }

    HWY_INLINE void find(const CrossedRows::Cell* cells, const CrossedRows::Cell* end,
                         const CellTriangle* triangles) {
        while (cells < end) {
            int32_t columns[TriangleNumbers::most + most_row_lanes] = {};
            int n = 0;
            const CrossedRows::Cell* last = cells;
            for (; last < end && n + last->count <= TriangleNumbers::most; ++last)
                for (int i = 0; i < last->count; ++i)
                    columns[n++] = last->x;
            m_numbers.template load<quadratic, soft>(m_net, m_strict, m_lattice.vertex_site(0, m_y),
                                                     m_lattice.stride(), triangles + cells->first,
                                                     columns, n);
            const int first = cells->first;
            for (; cells < last; ++cells)
                if (m_numbers.tame())
                    find_means<true>(*cells, cells->first - first);
                else
                    find_means<false>(*cells, cells->first - first);
        }
    }

private:
    template <bool tame>
    HWY_INLINE void find_means(const CrossedRows::Cell& cell, int first) {
        const RowTag d;
        const int lanes = TriangleNumbers::lanes();
        HWY_ALIGN float f[group_size][MeanLanes::count];
        for (int at = 0; at < MeanLanes::count; at += lanes) {
            const auto triangle = triangles_of(cell.count, first, at);
            if (cell.count <= lanes) {
                const auto index = hn::IndicesFromVec(d, triangle);
                evaluate<tame>(
                    first, at,
                    [&](const float* p)
                        HWY_ATTR { return RowLanes(hn::TableLookupLanes(hn::LoadU(d, p), index)); },
                    f);
            } else if (hn::MaxLanes(d) < MeanLanes::count) {
                evaluate<tame>(
                    first, at,
                    [&](const float* p)
                        HWY_ATTR { return RowLanes(hn::GatherIndex(d, p, triangle)); },
                    f);
            }
        }
        store(cell.x, f);
    }

    /// Which of a cell's triangles each position belongs to.
    HWY_INLINE hn::Vec<hn::RebindToSigned<RowTag>> triangles_of(int count, int first,
                                                                int at) const {
        const hn::RebindToSigned<RowTag> di;
        const auto bit = hn::LoadU(di, m_positions.bit + at);
        auto triangle = hn::Zero(di);
        const auto choose = [&](int t) HWY_ATTR {
            const auto positions = hn::Set(di, int32_t(m_numbers.positions(first + t)));
            triangle = hn::IfThenElse(hn::TestBit(positions, bit), hn::Set(di, t), triangle);
        };
        // Those of cells that follow may be among the first ones: the cell's own, which have all
        // positions, come last.
        constexpr int usual = 8;
        for (int t = count - 1; t >= usual; --t)
            choose(t);
        for (int t = usual - 1; t >= 0; --t)
            choose(t);
        return triangle;
    }

    template <bool tame, class LookUp>
    HWY_INLINE void evaluate(int first, int at, LookUp&& look_up,
                             float f[group_size][MeanLanes::count]) const {
        const auto planes = m_numbers.planes(first, look_up);
        const CrossingWeights<RowLanes> b(planes, RowLanes::load(m_positions.x + at),
                                          RowLanes::load(m_positions.y + at));
        for (int c = 0; c < int(m_net.count); ++c) {
            Patch<RowLanes> patch;
            m_numbers.template patch<quadratic, soft>(c, first, look_up, patch);
            patch.template at<quadratic, soft, tame>(b.b0, b.b1, b.b2).store(f[c] + at);
        }
    }

    HWY_INLINE void store(int x, const float f[group_size][MeanLanes::count]) const {
        const hn::CappedTag<float, most_in_pixel> d4;
        using Quadrants = PixelLanes;
        const CellNumbers values(m_net, m_net.values, m_lattice.vertex_site(x, m_y));
        HWY_ALIGN float pixels[4 * most_in_pixel];
        for (int k = 0; k < 4; ++k)
            PixelLanes::load(values.corner(0, k & 1, k >> 1)).store(pixels + k * most_in_pixel);
        Quadrants z[most_in_pixel], mean[most_in_pixel];
        hn::LoadInterleaved4(d4, pixels, z[0].v, z[1].v, z[2].v, z[3].v);
        for (int c = 0; c < most_in_pixel; ++c) {
            mean[c] = Quadrants(0.0f);
            if (c >= int(m_net.count))
                continue;
            for (int turn = 0; turn < 4; ++turn)
                mean[c] = mean[c] + (Quadrants::load(f[c] + 4 * turn) - z[c]);
            mean[c] = mean[c] * Quadrants(0.25f);
        }
        hn::StoreInterleaved4(mean[0].v, mean[1].v, mean[2].v, mean[3].v, d4, pixels);
        for (int k = 0; k < 4; ++k)
            store_pixel(PixelLanes::load(pixels + k * most_in_pixel), int(m_net.count),
                        m_means + size_t(k) * m_row + ptrdiff_t(x) * m_net.count);
    }

    const Lattice& m_lattice;
    const NetView m_net;
    const float* m_strict;
    const int m_y;
    float* const m_means;
    const size_t m_row;
    const MeanLanes m_positions;
    TriangleNumbers m_numbers;
};
