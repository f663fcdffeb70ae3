// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: triangles that cross cells, a lane a triangle, of one
// channel.
// Needs: <algorithm>, <cstring>, crossed_cell.h, control_net.h, patch-inl.h, blocks-inl.h,
// row_lanes-inl.h.

/// What triangles have, a number each.
class TriangleNumbers {
public:
    static constexpr int most = 32;

    /// Of n triangles, at most so many, of cells in these columns of the row with its first corner
    /// at this site. As many columns more as fill a vector are read, and must be the row's.
    template <bool quadratic, bool soft>
    HWY_INLINE void load(const NetView& net, Bounds bounds, int site, int stride,
                         const CellTriangle* triangles, const int32_t* columns, int n) {
        static_assert(sizeof(CellTriangle) == 2 * sizeof(int32_t), "two words");
        std::memcpy(m_words, triangles, size_t(n) * sizeof(CellTriangle));
        std::fill_n(m_words + 2 * n, 2 * most_lanes, 0);
        m_to_odd = floats_between(net.values.even, net.values.odd);
        m_to_odd_soft = floats_between(net.soft.even, net.soft.odd);
        m_finite = true;
        for (int i = 0; i < n; i += lanes()) {
            place<quadratic, soft>(i, columns + i, stride, int(net.count));
            separate<quadratic, soft>(net, net.place(site), i, n);
        }
        for (int c = 0; c < int(net.count); ++c)
            for (int i = 0; i < n; i += lanes()) {
                if (m_finite)
                    find_range<true>(c, bounds, i);
                else
                    find_range<false>(c, bounds, i);
            }
    }

    bool surely_finite() const { return m_finite; }

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
    static constexpr int room = most + most_lanes;
    using IntTag = hn::RebindToSigned<RowTag>;

    static ptrdiff_t floats_between(const float* from, const float* to) {
        return (reinterpret_cast<intptr_t>(to) - reinterpret_cast<intptr_t>(from)) /
               ptrdiff_t(sizeof(float));
    }

    /// Byte k of each lane as a signed number.
    template <int k>
    static HWY_INLINE hn::Vec<IntTag> signed_byte(hn::Vec<IntTag> x) {
        return hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * k>(x));
    }

    /// Where what the net has of triangles i, i + 1, ... is, and their planes, as CrossingTriangle
    /// has them.
    template <bool quadratic, bool soft>
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
            store_places(hn::Mul(vertex[k], floats), hn::Zero(di), 0, m_places[z + k]);
        }
        for (int k = 0; k < 3; ++k) {
            const auto both = hn::Add(vertex[k], vertex[(k + 1) % 3]),
                       edge = hn::Mul(hn::ShiftRight<1>(both), floats),
                       odd = hn::And(both, hn::Set(di, 1));
            if (quadratic)
                store_places(edge, odd, m_to_odd, m_places[e + k]);
            if (soft)
                store_places(edge, odd, m_to_odd_soft, m_places[q + k]);
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

    /// Places, or where they are `odd`, so many floats on.
    static HWY_INLINE void store_places(hn::Vec<IntTag> place, hn::Vec<IntTag> odd, ptrdiff_t on,
                                        int64_t* to) {
        const hn::Half<IntTag> half;
        const hn::Rebind<int64_t, hn::Half<IntTag>> wide;
        const auto store = [&](auto p, auto o, int64_t* at) HWY_ATTR {
            const auto is_odd = hn::Sub(hn::Zero(wide), hn::PromoteTo(wide, o));
            hn::StoreU(hn::Add(hn::PromoteTo(wide, p), hn::And(is_odd, hn::Set(wide, on))), wide,
                       at);
        };
        store(hn::LowerHalf(half, place), hn::LowerHalf(half, odd), to);
        store(hn::UpperHalf(half, place), hn::UpperHalf(half, odd), to + hn::Lanes(wide));
    }

    /// The channels of what the net has of triangles i, i + 1, ..., each by itself; from: where the
    /// row is.
    template <bool quadratic, bool soft>
    HWY_INLINE void separate(const NetView& net, ptrdiff_t from, int i, int n) {
        const RowTag d;
        const int count = int(net.count);
        const float* const rows[] = {net.values.even + from, net.values.even + from,
                                     soft ? net.soft.even + from : nullptr};
        Blocks size[group_size];
        for (Blocks& of_channel : size)
            of_channel = Blocks(0.0f);
        for (int number = z; number < low; ++number) {
            if ((!quadratic && e <= number && number < q) || (!soft && q <= number))
                continue;
            Blocks channel[group_size];
            load_channels(rows[number / 3], m_places[number], channel);
            for (int c = 0; c < count; ++c) {
                channel[c].store(m_numbers[c][number] + i);
                if (number < e)
                    size[c] = size[c] + abs(channel[c]);
            }
        }
        const auto here = hn::FirstN(d, size_t(std::min(n - i, lanes())));
        for (int c = 0; c < count; ++c)
            m_finite &= RowLanes::all_within(Patch<RowLanes>::finite_size,
                                             hn::IfThenElseZero(here, size[c].v));
    }

    template <bool all_finite>
    HWY_INLINE void find_range(int c, Bounds bounds, int i) {
        float(*numbers)[room] = m_numbers[c];
        Patch<RowLanes> p;
        p.z0 = RowLanes::load(numbers[z] + i), p.z1 = RowLanes::load(numbers[z + 1] + i);
        p.z2 = RowLanes::load(numbers[z + 2] + i);
        p.template find_range<all_finite>(bounds);
        p.low.store(numbers[low] + i);
        p.high.store(numbers[high] + i);
    }

    bool m_finite = false;
    int32_t m_words[2 * room]; ///< the triangles, as they are kept
    /// From the row's first in even columns to each number of as many triangles as there are
    /// lanes, in floats; and to the first in odd columns.
    int64_t m_places[low][most_lanes];
    ptrdiff_t m_to_odd = 0, m_to_odd_soft = 0;
    float m_planes[6][room];
    float m_numbers[group_size][all][room];
};
