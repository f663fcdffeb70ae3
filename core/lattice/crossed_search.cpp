// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_search.h"

#include <cstring>

#include "core/base/arith.h"
#include "core/base/vectors/compress_lanes.h"
#include "core/base/vectors/gathers.h"
#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/crossed_search.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;
using VF = hn::Vec<D>;
using MI = hn::Mask<DI>;

#include "core/base/vectors/compress-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/site_lanes-inl.h"

// Corners are vectors from their cells' first corners, in pixels.

HWY_INLINE VecLanes either(MI where, VecLanes yes, VecLanes no) {
    return {hn::IfThenElse(where, yes.xy, no.xy)};
}
/// Ascending as sites are: y, then x, whose sign is turned.
HWY_INLINE VI address(VecLanes corner) {
    return hn::Xor(corner.xy, hn::Set(DI(), 0x8000));
}

/// Where (along.x * y - along.y * x) >= least. Whatever tells on which side of a line through the
/// cell a position lies, or round the centre, is exact in float32: products and their differences
/// are multiples of 2^-16 below 2^8, and where `least` is not, it is out of their reach.
struct Line {
    VF along_x, along_y, least;

    /// The positions that lie to the left of the line from `from` to `to`, shifted by the tie rule.
    HWY_INLINE Line(VecLanes from, VecLanes to) {
        const D d;
        const VecLanes along = to - from;
        along_x = hn::ConvertTo(d, along.x());
        along_y = hn::ConvertTo(d, along.y());
        const auto on_it = hn::Lt(hn::Mul(hn::Set(d, 256.0f), along_y), along_x); // tie_inside()
        const VF beside = hn::Sub(hn::Mul(along_x, hn::ConvertTo(d, from.y())),
                                  hn::Mul(along_y, hn::ConvertTo(d, from.x())));
        least = hn::Add(beside, least_step(on_it));
    }
    /// The positions to which lines from the cell's centre leave c on their left, where locate()
    /// turns to.
    explicit HWY_INLINE Line(VecLanes c) {
        const D d;
        const VecLanes minus = VecLanes::ones() - (c + c);
        along_x = hn::ConvertTo(d, minus.x());
        along_y = hn::ConvertTo(d, minus.y());
        const auto on_it = hn::Lt(along_y, hn::Zero(d));
        least = hn::Add(hn::ConvertTo(d, hn::Sub(c.y(), c.x())), least_step(on_it));
    }

private:
    static HWY_INLINE VF least_step(hn::Mask<D> on_it) {
        return hn::IfThenZeroElse(on_it, hn::Set(D(), position_unit));
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
        HWY_ALIGN float across[lines][CrossedSearch::most_positions * most_lanes];
        for (int c = 0; c < columns; ++c)
            for (int k = 0; k < lines; ++k)
                hn::Store(hn::Mul(line[k]->along_y, hn::Set(d, m_positions.x()[c])), d,
                          across[k] + most_lanes * c);
        VI bit = hn::Set(DI(), 1);
        for (int r = 0; r < rows; ++r) {
            const VF y = hn::Set(d, m_positions.y()[r * columns]);
            VF down[lines];
            for (int k = 0; k < lines; ++k)
                down[k] = hn::Mul(line[k]->along_x, y);
            for (int c = 0; c < columns; ++c) {
                VF side[lines];
                for (int k = 0; k < lines; ++k)
                    side[k] = hn::Sub(down[k], hn::Load(d, across[k] + most_lanes * c));
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

/// Groups of positions that are beyond side s t of a triangle whose third corner is `own`.
struct PositionGroups {
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
        : m_mesh(lattice), m_first_site(lattice.vertex_site(0, cy)), m_grid(positions),
          m_all((1 << positions.count()) - 1), m_found(found) {}

    /// Positions of cells `cell` on their way from the central edges.
    HWY_INLINE void begin(VI cell, MI here, PositionGroups& next) {
        const DI di;
        const VecLanes ones = VecLanes::ones();
        const EdgeLanes centre = m_mesh.edge(site(ones, cell));
        const VecLanes s = half(ones - centre.v), t = half(ones + centre.v);
        const Line line(s, t);
        const Line* const lines[] = {&line};
        VI to_the_left = hn::Zero(di);
        m_grid.each(lines, [&](VI bit, const VF* side) HWY_ATTR {
            const auto is_left = hn::RebindMask(di, hn::Le(line.least, side[0]));
            to_the_left = hn::Or(to_the_left, hn::IfThenElseZero(is_left, bit));
        });
        const VI all = hn::IfThenElseZero(here, hn::Set(di, m_all));
        to_the_left = hn::And(to_the_left, all);
        enter(s, t, half(ones + centre.left), to_the_left, to_the_left, cell, next);
        const VI to_the_right = hn::AndNot(to_the_left, all);
        enter(t, s, half(ones + centre.right), to_the_right, to_the_right, cell, next);
    }

    /// Take groups i, i + 1, ..., as many as a vector has lanes, a triangle further.
    HWY_INLINE void go_on(const PositionGroups& groups, int i, PositionGroups& next) {
        const DI di;
        const auto here = hn::FirstN(di, std::min(size_t(groups.count - i), hn::Lanes(di)));
        const auto load = [&](const int32_t* p)
                              HWY_ATTR { return hn::IfThenElseZero(here, hn::LoadU(di, p + i)); };
        const VI side = load(groups.side), rest = load(groups.own_and_positions),
                 cell = load(groups.cell);
        VecLanes s = VecLanes::of_bytes<0>(side), t = VecLanes::of_bytes<2>(side);
        const VecLanes own = VecLanes::of_bytes<0>(rest);
        const VI positions = hn::And(hn::ShiftRight<16>(rest), hn::Set(di, m_all));
        const RecordLanes edge = m_mesh.record(site(s + t, cell));
        const VecLanes apex = apex_beyond(edge, (own + own) - (s + t));
        VecLanes c = half((s + t) + apex);
        VI going = positions;
        const MI rim = hn::And(here, apex.zero());
        if (!hn::AllFalse(di, rim)) {
            // They stay in the triangle that they come from.
            const VecLanes from = s;
            s = either(rim, t, s);
            t = either(rim, from, t);
            c = either(rim, own, c);
            going = hn::IfThenZeroElse(rim, going);
        }
        enter(s, t, c, positions, going, cell, next);
    }

private:
    /// The sites at these places in the doubled lattice from the cells' first corners.
    HWY_INLINE Ints site(VecLanes place, VI cell) const {
        const VI column = hn::ShiftRight<number_bits>(cell);
        const Ints first{hn::Add(hn::Add(column, column), hn::Set(DI(), m_first_site))};
        return first + m_mesh.offset(place);
    }

    /// In the triangle s, t, c, which `positions` come to across s t, and which those of `going`
    /// may leave.
    HWY_INLINE void enter(VecLanes s, VecLanes t, VecLanes c, VI positions, VI going, VI cell,
                          PositionGroups& next) {
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
        const VI ps = s.bytes(), pt = t.bytes(), pc = c.bytes();
        add(next, pc, pt, ps, across_tc, cell);
        add(next, ps, pc, pt, across_cs, cell);

        const VI held = hn::AndNot(hn::Or(across_tc, across_cs), positions);
        const MI any = hn::Gt(held, hn::Zero(di));
        const VI as = address(s), at = address(t);
        const MI t_first = hn::Lt(at, as), c_first = hn::Lt(address(c), hn::Min(as, at));
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

    HWY_INLINE void add(PositionGroups& groups, VI s, VI t, VI own, VI positions, VI cell) const {
        const DI di;
        const MI any = hn::Gt(positions, hn::Zero(di));
        store_compressed(hn::Or(s, upper_half(t)), any, groups.side + groups.count);
        store_compressed(hn::Or(own, upper_half(positions)), any,
                         groups.own_and_positions + groups.count);
        groups.count += int(store_compressed(cell, any, groups.cell + groups.count));
    }

    SiteLanes m_mesh;
    int m_first_site;
    Grid m_grid;
    int32_t m_all;
    CrossedSearch::Found& m_found;
};

HWY_ATTR void search(const Lattice& lattice, int cy, const int* x, int n,
                     const CellPositions& positions, CrossedSearch::Found& found) {
    const DI di;
    const int lanes = int(hn::Lanes(di));
    Searcher searcher(lattice, cy, positions, found);
    PositionGroups groups[2];
    HWY_ALIGN int32_t cell[most_lanes];
    for (int i = 0; i < n; i += lanes) {
        for (int k = 0; k < lanes; ++k)
            cell[k] = i + k < n ? x[i + k] << number_bits | (i + k) : cell[0];
        searcher.begin(hn::Load(di, cell), hn::FirstN(di, size_t(std::min(n - i, lanes))),
                       groups[0]);
    }
    for (int turn = 0; groups[turn].count; turn ^= 1) {
        PositionGroups &now = groups[turn], &next = groups[turn ^ 1];
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
