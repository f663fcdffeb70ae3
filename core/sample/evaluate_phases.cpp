// SPDX-License-Identifier: Apache-2.0
#include "core/sample/evaluate_phases.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/base/arith.h"
#include "core/base/vectors/row_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sample/evaluate_phases.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

#include "core/base/vectors/lanes-inl.h"
#include "core/surface/for_surface-inl.h"
#include "core/surface/patch-inl.h"

#include "core/base/vectors/row_lanes-inl.h"

/// Of the quarters of a cell, between both diagonals, number 2 * i + j lies in triangle i of cells
/// divided down and in triangle j of those divided up.
constexpr int quarters = 4;
/// Which weight a quarter's positions have the same in both (DividedWeights); 3: none.
constexpr int same_weight[quarters] = {1, 0, 2, 3};

/// A position in plain cells, whichever way these are divided.
struct PlainPosition {
    float down[3], up[3]; ///< its weights in its triangle
    int number;           ///< among a cell's, row by row
};

/// The positions of a cell, by the quarter that they lie in.
struct PlainPositions {
    static constexpr int most = most_phases * LocatedBlock::most_rows;
    PlainPosition of_quarter[quarters][most];
    int count[quarters] = {};

    HWY_INLINE PlainPositions(const float* x, int columns, const float* y, int rows) {
        const auto place = [](const DividedWeights<OneLane>& w, float b[3]) HWY_ATTR {
            b[0] = hn::GetLane(w.b0.v), b[1] = hn::GetLane(w.b1.v), b[2] = hn::GetLane(w.b2.v);
            return int(!(hn::GetLane(w.d.v) < 0));
        };
        for (int i = 0; i < rows * columns; ++i) {
            const OneLane px(x[i % columns]), py(y[i / columns]);
            PlainPosition p;
            p.number = i;
            const int second_down = place(DividedWeights<OneLane>::down(px, py), p.down),
                      second_up = place(DividedWeights<OneLane>::up(px, py), p.up),
                      quarter = 2 * second_down + second_up;
            of_quarter[quarter][count[quarter]++] = p;
        }
    }
};

/// Cells that are made before their values are handed out: whole vectors of any number of channels.
constexpr int cells_together = 32;
static_assert(cells_together % most_lanes == 0, "whole vectors");

/// The surface in neighbouring cells: for each position of a cell a row of floats, `count` a cell.
struct MadeCells {
    static constexpr int beyond = most_lanes; ///< that may be written before, and read past
    HWY_ALIGN float floats[PlainPositions::most][beyond + cells_together * most_in_pixel + beyond];

    HWY_INLINE float* at(int position) { return floats[position] + beyond; }
    HWY_INLINE const float* at(int position) const { return floats[position] + beyond; }
};

/// Neighbouring cells, one after the other in the lanes, however each is divided.
template <bool quadratic, bool soft>
struct PlainCells {
    using T = RowLanes;
    PlainCell<T> cell;
    T is_down; ///< 1 or 0

    HWY_INLINE T either(T if_down, T if_up) const {
        return if_less(T(0.0f), is_down, if_down, if_up);
    }

    /// The triangles that the positions of a quarter lie in.
    template <int quarter, bool all_finite>
    HWY_INLINE Patch<T> triangles(Bounds bounds) const {
        Patch<T> down[2], up[2], p;
        cell.template divide_down<soft>(down[0], down[1]);
        cell.template divide_up<soft>(up[0], up[1]);
        const Patch<T>&if_down = down[quarter / 2], &if_up = up[quarter % 2];
        p.z0 = either(if_down.z0, if_up.z0), p.z1 = either(if_down.z1, if_up.z1);
        p.z2 = either(if_down.z2, if_up.z2);
        if (quadratic) {
            p.e01 = either(if_down.e01, if_up.e01), p.e12 = either(if_down.e12, if_up.e12);
            p.e20 = either(if_down.e20, if_up.e20);
        }
        if (soft) {
            p.q01 = either(if_down.q01, if_up.q01), p.q12 = either(if_down.q12, if_up.q12);
            p.q20 = either(if_down.q20, if_up.q20);
        }
        p.template find_range<all_finite>(bounds);
        return p;
    }

    template <int quarter, int k>
    HWY_INLINE T weight(const PlainPosition& position) const {
        if constexpr (k == same_weight[quarter])
            return T(position.down[k]);
        else
            return either(T(position.down[k]), T(position.up[k]));
    }

    /// The surface at the positions of a quarter, from float `at` on of their rows.
    template <int quarter, bool all_finite>
    HWY_INLINE void make(const PlainPositions& positions, Bounds bounds, ptrdiff_t at,
                         MadeCells& made) const {
        const int count = positions.count[quarter];
        if (count == 0)
            return;
        const Patch<T> p = triangles<quarter, all_finite>(bounds);
        for (int i = 0; i < count; ++i) {
            const PlainPosition& position = positions.of_quarter[quarter][i];
            p.template at<quadratic, soft, all_finite>(weight<quarter, 0>(position),
                                                       weight<quarter, 1>(position),
                                                       weight<quarter, 2>(position))
                .store(made.at(position.number) + at);
        }
    }
    template <bool all_finite>
    HWY_INLINE void make(const PlainPositions& positions, Bounds bounds, ptrdiff_t at,
                         MadeCells& made) const {
        static_assert(quarters == 4, "each");
        make<0, all_finite>(positions, bounds, at, made);
        make<1, all_finite>(positions, bounds, at, made);
        make<2, all_finite>(positions, bounds, at, made);
        make<3, all_finite>(positions, bounds, at, made);
    }
    /// Of what is not surely finite: rare, so out of the way.
    HWY_NOINLINE void make_wild(const PlainPositions& positions, Bounds bounds, ptrdiff_t at,
                                MadeCells& made) const {
        make<false>(positions, bounds, at, made);
    }
};

/// Where the rows of values of all cells go.
struct PhaseRows {
    float* first; ///< the first position of the first cell
    size_t row;   ///< floats from a row to the next
    int channels; ///< floats a position has there
};

/// Hands out what `cells` cells have at one row of their positions, made.at(first) and on: `count`
/// of `channels` floats a position, phases of them a cell.
template <int phases>
HWY_INLINE void store_row(const MadeCells& made, int first, int cells, int count, int channels,
                          float* to) {
    // What is too much of a pixel is overwritten by those that follow, unless it is the last.
    const int at_once = count == channels ? cells - most_in_pixel / phases : 0;
    ptrdiff_t from = 0;
    int cell = 0;
    for (; cell < at_once; ++cell, from += count)
        for (int k = 0; k < phases; ++k, to += count)
            PixelLanes::load(made.at(first + k) + from).store(to);
    for (; cell < cells; ++cell, from += count)
        for (int k = 0; k < phases; ++k, to += channels)
            store_pixel(PixelLanes::load(made.at(first + k) + from), count, to);
}

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_cells(const ControlNet& whole, const LocatedBlock& block,
                               const Columns::Alike& alike, const PlainPositions& positions,
                               const PhaseRows& out) {
    using T = RowLanes;
    const NetView net(whole);
    const int first_site = 2 * (block.cell_row * whole.stride + alike.cell), count = int(net.count);
    const CellNumbers values(net, net.values, first_site);
    CellNumbers softness;
    if (soft)
        softness = CellNumbers(net, net.soft, first_site);
    const Bounds bounds = whole.bounds;
    const ptrdiff_t lanes = hn::Lanes(RowTag());
    MadeCells made;
    for (int x = 0; x < alike.cells; x += cells_together) {
        const int together = std::min(alike.cells - x, cells_together);
        const ptrdiff_t begin = ptrdiff_t(x) * count, end = begin + together * count;
        for (ptrdiff_t next = begin; next < end; next += lanes) {
            // The last vector ends with the cells.
            const ptrdiff_t at = std::min(next, ptrdiff_t(alike.cells) * count - lanes);
            const ptrdiff_t pixel = ptrdiff_t(uint32_t(at) / uint32_t(count));
            const RowPlace place{at, pixel, int(at - pixel * count)};
            PlainCells<quadratic, soft> cells;
            cells.cell.template load<quadratic, soft>(
                values, softness, at, [](const float* p) HWY_ATTR { return T::load(p); });
            cells.is_down = spread<T>(block.down.data(), place, count);
            if (cells.cell.is_surely_finite())
                cells.template make<true>(positions, bounds, at - begin, made);
            else
                cells.make_wild(positions, bounds, at - begin, made);
        }
        float* to = out.first + ptrdiff_t(x) * alike.phases * out.channels;
        for (int r = 0; r < block.count; ++r, to += out.row) {
            const int first = r * alike.phases;
            static_assert(least_phases == 2 && most_phases == 4, "the cases");
            if (alike.phases == 2)
                store_row<2>(made, first, together, count, out.channels, to);
            else if (alike.phases == 3)
                store_row<3>(made, first, together, count, out.channels, to);
            else
                store_row<4>(made, first, together, count, out.channels, to);
        }
    }
}

HWY_ATTR void evaluate_phases(const ControlNet& net, Surface surface, const Columns& columns,
                              const LocatedBlock& block, const GroupOutput& to) {
    const Columns::Alike& alike = columns.alike;
    const PlainPositions positions(columns.x.data() + alike.begin, alike.phases, block.y,
                                   block.count);
    const PhaseRows rows{to.at(alike.begin), to.row, to.channels};
    for_surface(net, surface, [&](auto quadratic, auto soft) HWY_ATTR {
        evaluate_cells<decltype(quadratic)::value, decltype(soft)::value>(net, block, alike,
                                                                          positions, rows);
    });
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(evaluate_phases);

void evaluate_phases(const ControlNet& net, Surface surface, const Columns& columns,
                     const LocatedBlock& block, const GroupOutput& to) {
    HWY_DYNAMIC_DISPATCH(evaluate_phases)(net, surface, columns, block, to);
}

} // namespace ddt
#endif
