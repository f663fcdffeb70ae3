// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_search.h"

#include <cstring>

#include "core/base/arith.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/crossed_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;
using VF = hn::Vec<D>;
using MI = hn::Mask<DI>;

#include "core/base/compress-inl.h"

/// Byte k of each lane as a signed number.
template <int k>
HWY_INLINE VI signed_byte(VI x) {
    return hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * k>(x));
}

/// Corners, a lane each, in pixels from their cells' first corners.
struct CornerLanes {
    VI x, y;
    friend HWY_INLINE CornerLanes operator+(CornerLanes a, CornerLanes b) {
        return {hn::Add(a.x, b.x), hn::Add(a.y, b.y)};
    }
    friend HWY_INLINE CornerLanes operator-(CornerLanes a, CornerLanes b) {
        return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
    }
    HWY_INLINE CornerLanes half() const { return {hn::ShiftRight<1>(x), hn::ShiftRight<1>(y)}; }
    HWY_INLINE CornerLanes instead(MI where, CornerLanes other) const {
        return {hn::IfThenElse(where, other.x, x), hn::IfThenElse(where, other.y, y)};
    }
    /// In the low two bytes.
    HWY_INLINE VI packed() const {
        const VI byte = hn::Set(DI(), 255);
        return hn::Or(hn::And(x, byte), hn::ShiftLeft<8>(hn::And(y, byte)));
    }
    /// Ascending as sites are.
    HWY_INLINE VI address() const { return hn::Add(hn::ShiftLeft<16>(y), x); }
};

/// Where (along.x * y - along.y * x) >= least. Whatever tells on which side of a line through the
/// cell a position lies, or round the centre, is exact in float32: products and their differences
/// are multiples of 2^-16 below 2^8, and where `least` is not, it is out of their reach.
struct Line {
    VF along_x, along_y, least;

    /// The positions that lie to the left of the line from `from` to `to`, shifted by the tie rule.
    HWY_INLINE Line(CornerLanes from, CornerLanes to) {
        const D d;
        const CornerLanes along = to - from;
        along_x = hn::ConvertTo(d, along.x);
        along_y = hn::ConvertTo(d, along.y);
        const auto on_it = hn::Lt(hn::Mul(hn::Set(d, 256.0f), along_y), along_x); // tie_inside()
        const VF beside = hn::Sub(hn::Mul(along_x, hn::ConvertTo(d, from.y)),
                                  hn::Mul(along_y, hn::ConvertTo(d, from.x)));
        least = hn::Add(beside, least_step(on_it));
    }
    /// The positions to which lines from the cell's centre leave c on their left, where locate()
    /// turns to.
    explicit HWY_INLINE Line(CornerLanes c) {
        const D d;
        const VI one = hn::Set(DI(), 1), zero = hn::Zero(DI());
        const VI minus_x = hn::Sub(one, hn::Add(c.x, c.x)),
                 minus_y = hn::Sub(one, hn::Add(c.y, c.y));
        along_x = hn::ConvertTo(d, minus_x);
        along_y = hn::ConvertTo(d, minus_y);
        const auto on_it = hn::RebindMask(d, hn::Lt(minus_y, zero));
        least = hn::Add(hn::ConvertTo(d, hn::Sub(c.y, c.x)), least_step(on_it));
    }

private:
    static HWY_INLINE VF least_step(hn::Mask<D> on_it) {
        return hn::IfThenZeroElse(on_it, hn::Set(D(), 1.0f / float(position_one)));
    }
};

/// A grid's positions beside lines.
class Grid {
public:
    explicit HWY_INLINE Grid(const CellPositions& positions) : m_positions(positions) {}

    /// Call f(bit, sides) for each position; sides: an array of values that are to be compared with
    /// the lines' least.
    template <int lines, class F>
    HWY_INLINE void each(const Line* const (&line)[lines], F&& f) const {
        const D d;
        const int columns = m_positions.columns(), rows = m_positions.rows();
        HWY_ALIGN float across[lines][CrossedSearch::most_positions * 16];
        for (int c = 0; c < columns; ++c)
            for (int k = 0; k < lines; ++k)
                hn::Store(hn::Mul(line[k]->along_y, hn::Set(d, m_positions.x()[c])), d,
                          across[k] + 16 * c);
        VI bit = hn::Set(DI(), 1);
        for (int r = 0; r < rows; ++r) {
            const VF y = hn::Set(d, m_positions.y()[r * columns]);
            VF down[lines];
            for (int k = 0; k < lines; ++k)
                down[k] = hn::Mul(line[k]->along_x, y);
            for (int c = 0; c < columns; ++c) {
                VF side[lines];
                for (int k = 0; k < lines; ++k)
                    side[k] = hn::Sub(down[k], hn::Load(d, across[k] + 16 * c));
                f(bit, side);
                bit = hn::Add(bit, bit);
            }
        }
    }

private:
    const CellPositions& m_positions;
};

/// A cell's column and its number among those that are searched, in one.
constexpr int number_bits = 7;
static_assert(CrossedSearch::most_cells == 1 << number_bits, "every number fits");

/// Lots of positions that are beyond side s t of a triangle whose third corner is `own`.
struct Lots {
    int count = 0;
    int32_t side[CrossedSearch::Found::room];              ///< s and t, bytes x, y, x, y
    int32_t own_and_positions[CrossedSearch::Found::room]; ///< bytes x, y, and a bit a position
    int32_t cell[CrossedSearch::Found::room];              ///< column and number
};

HWY_INLINE VI upper_half(VI x) {
    return hn::ShiftLeft<16>(x);
}

class Searcher {
public:
    HWY_INLINE Searcher(const Lattice& lattice, int cy, const CellPositions& positions,
                        CrossedSearch::Found& found)
        : m_sites(reinterpret_cast<const int64_t*>(lattice.sites())),
          m_first_site(lattice.vertex_site(0, cy)), m_stride(lattice.stride()), m_grid(positions),
          m_all((1 << positions.count()) - 1), m_found(found) {}

    /// Positions of cells `cell` on their way from the central edges.
    HWY_INLINE void begin(VI cell, MI here, Lots& next) {
        const DI di;
        const VI one = hn::Set(di, 1);
        VI first, second;
        load_edges({one, one}, cell, first, second);
        const CornerLanes v{signed_byte<0>(first), signed_byte<1>(first)},
            left{signed_byte<2>(first), signed_byte<3>(first)},
            right{signed_byte<0>(second), signed_byte<1>(second)}, ones{one, one};
        const CornerLanes s = (ones - v).half(), t = (ones + v).half();
        const Line line(s, t);
        const Line* const lines[] = {&line};
        VI to_the_left = hn::Zero(di);
        m_grid.each(lines, [&](VI bit, const VF* side) HWY_ATTR {
            const auto is_left = hn::RebindMask(di, hn::Le(line.least, side[0]));
            to_the_left = hn::Or(to_the_left, hn::IfThenElseZero(is_left, bit));
        });
        const VI all = hn::IfThenElseZero(here, hn::Set(di, m_all));
        to_the_left = hn::And(to_the_left, all);
        enter(s, t, (ones + left).half(), to_the_left, to_the_left, cell, next);
        const VI to_the_right = hn::AndNot(to_the_left, all);
        enter(t, s, (ones + right).half(), to_the_right, to_the_right, cell, next);
    }

    /// Lots i, i + 1, ... of some, as many as a vector has.
    HWY_INLINE void go_on(const Lots& lots, int i, Lots& next) {
        const DI di;
        const auto here = hn::FirstN(di, std::min(size_t(lots.count - i), hn::Lanes(di)));
        const auto load = [&](const int32_t* p)
                              HWY_ATTR { return hn::IfThenElseZero(here, hn::LoadU(di, p + i)); };
        const VI side = load(lots.side), rest = load(lots.own_and_positions),
                 cell = load(lots.cell);
        CornerLanes s{signed_byte<0>(side), signed_byte<1>(side)},
            t{signed_byte<2>(side), signed_byte<3>(side)};
        const CornerLanes own{signed_byte<0>(rest), signed_byte<1>(rest)};
        const VI positions = hn::And(hn::ShiftRight<16>(rest), hn::Set(di, m_all));
        VI first, second;
        load_edges(s + t, cell, first, second);
        const CornerLanes apexes = CornerLanes{signed_byte<2>(first), signed_byte<3>(first)} +
                                   CornerLanes{signed_byte<0>(second), signed_byte<1>(second)};
        // apex_beyond(): c is s + t + apex, halved.
        const CornerLanes apex = (apexes + (s + t)) - (own + own);
        CornerLanes c = (s + t) - own + apexes.half();
        VI going = positions;
        const MI rim = hn::And(here, hn::Eq(hn::Or(apex.x, apex.y), hn::Zero(di)));
        if (!hn::AllFalse(di, rim)) {
            // They stay in the triangle that they come from.
            const CornerLanes from = s;
            s = s.instead(rim, t);
            t = t.instead(rim, from);
            c = c.instead(rim, own);
            going = hn::IfThenZeroElse(rim, going);
        }
        enter(s, t, c, positions, going, cell, next);
    }

private:
    /// The records of edges, which are at these places in the doubled lattice from the cells' first
    /// corners.
    HWY_INLINE void load_edges(CornerLanes place, VI cell, VI& first, VI& second) const {
        const DI di;
        const hn::Repartition<int64_t, DI> d64;
        const hn::Half<DI> half;
        const VI column = hn::ShiftRight<number_bits>(cell);
        const VI site = hn::Add(hn::Add(hn::Mul(place.y, hn::Set(di, m_stride)), place.x),
                                hn::Add(hn::Add(column, column), hn::Set(di, m_first_site)));
        const VI lower = hn::BitCast(
            di, hn::GatherIndex(d64, m_sites, hn::PromoteTo(d64, hn::LowerHalf(half, site))));
        const VI upper = hn::BitCast(
            di, hn::GatherIndex(d64, m_sites, hn::PromoteTo(d64, hn::UpperHalf(half, site))));
        first = hn::ConcatEven(di, upper, lower);
        second = hn::ConcatOdd(di, upper, lower);
    }

    /// In the triangle s, t, c, which `positions` come to across s t, and which those of `going`
    /// may leave.
    HWY_INLINE void enter(CornerLanes s, CornerLanes t, CornerLanes c, VI positions, VI going,
                          VI cell, Lots& next) {
        const DI di;
        const Line tc(t, c), cs(c, s), turn(c);
        const Line* const lines[] = {&tc, &cs, &turn};
        VI across_tc = hn::Zero(di), across_cs = across_tc;
        m_grid.each(lines, [&](VI bit, const VF* side) HWY_ATTR {
            const auto to_tc = hn::Le(turn.least, side[2]);
            const auto beyond_tc = hn::And(to_tc, hn::Lt(side[0], tc.least));
            const auto beyond_cs = hn::AndNot(to_tc, hn::Lt(side[1], cs.least));
            across_tc = hn::Or(across_tc, hn::IfThenElseZero(hn::RebindMask(di, beyond_tc), bit));
            across_cs = hn::Or(across_cs, hn::IfThenElseZero(hn::RebindMask(di, beyond_cs), bit));
        });
        across_tc = hn::And(across_tc, going);
        across_cs = hn::And(across_cs, going);
        const VI ps = s.packed(), pt = t.packed(), pc = c.packed();
        add(next, pc, pt, ps, across_tc, cell);
        add(next, ps, pc, pt, across_cs, cell);

        const VI held = hn::AndNot(hn::Or(across_tc, across_cs), positions);
        const MI any = hn::Gt(held, hn::Zero(di));
        const VI as = s.address(), at = t.address();
        const MI t_first = hn::Lt(at, as), c_first = hn::Lt(c.address(), hn::Min(as, at));
        const auto ordered = [&](VI if_s, VI if_t, VI if_c) HWY_ATTR {
            return hn::IfThenElse(c_first, if_c, hn::IfThenElse(t_first, if_t, if_s));
        };
        const VI p0 = ordered(ps, pt, pc), p1 = ordered(pt, pc, ps), p2 = ordered(pc, ps, pt);
        int32_t* const to = m_found.cell + m_found.count;
        store_compressed(hn::Or(p0, upper_half(p1)), any, m_found.corners_01 + m_found.count);
        store_compressed(hn::Or(p2, upper_half(held)), any,
                         m_found.corner_2_and_positions + m_found.count);
        m_found.count +=
            int(store_compressed(hn::And(cell, hn::Set(di, (1 << number_bits) - 1)), any, to));
    }

    HWY_INLINE void add(Lots& lots, VI s, VI t, VI own, VI positions, VI cell) const {
        const DI di;
        const MI any = hn::Gt(positions, hn::Zero(di));
        store_compressed(hn::Or(s, upper_half(t)), any, lots.side + lots.count);
        store_compressed(hn::Or(own, upper_half(positions)), any,
                         lots.own_and_positions + lots.count);
        lots.count += int(store_compressed(cell, any, lots.cell + lots.count));
    }

    const int64_t* m_sites;
    int m_first_site, m_stride;
    Grid m_grid;
    int32_t m_all;
    CrossedSearch::Found& m_found;
};

HWY_ATTR void search(const Lattice& lattice, int cy, const int* x, int n,
                     const CellPositions& positions, CrossedSearch::Found& found) {
    const DI di;
    const int lanes = int(hn::Lanes(di));
    Searcher searcher(lattice, cy, positions, found);
    Lots lots[2];
    HWY_ALIGN int32_t cell[16];
    for (int i = 0; i < n; i += lanes) {
        for (int k = 0; k < lanes; ++k)
            cell[k] = i + k < n ? x[i + k] << number_bits | (i + k) : cell[0];
        searcher.begin(hn::Load(di, cell), hn::FirstN(di, size_t(std::min(n - i, lanes))), lots[0]);
    }
    for (int turn = 0; lots[turn].count; turn ^= 1) {
        Lots &now = lots[turn], &next = lots[turn ^ 1];
        next.count = 0;
        for (int i = 0; i < now.count; i += lanes)
            searcher.go_on(now, i, next);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(search);

void CrossedSearch::sort(const Found& found, int cells) {
    int next[most_cells] = {};
    for (int i = 0; i < found.count; ++i)
        ++next[found.cell[i]];
    m_first[0] = 0;
    for (int i = 0; i < cells; ++i) {
        m_first[i + 1] = m_first[i] + next[i];
        next[i] = m_first[i];
    }
    for (int i = 0; i < found.count; ++i) {
        const int32_t words[] = {found.corners_01[i], found.corner_2_and_positions[i]};
        static_assert(sizeof words == sizeof(CellTriangle), "corners, then positions");
        std::memcpy(&m_triangles[next[found.cell[i]]++], words, sizeof words);
    }
}

void CrossedSearch::find(const Lattice& lattice, int cy, const int* x, int n,
                         const CellPositions& positions) {
    Found found;
    HWY_DYNAMIC_DISPATCH(search)(lattice, cy, x, n, positions, found);
    sort(found, n);
}

} // namespace ddt
#endif
