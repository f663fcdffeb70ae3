// SPDX-License-Identifier: Apache-2.0
#include "core/sample/phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/base/arith.h"
#include "core/base/row_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sample/phases.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

#include "core/base/lanes-inl.h"
#include "core/surface/for_surface-inl.h"
#include "core/surface/patch-inl.h"

#include "core/base/row_lanes-inl.h"

/// A position in plain cells, whichever way these are divided.
struct PlainPosition {
    float down[3], up[3]; ///< its weights in its triangle
    /// The quarter of the cell, between both diagonals, that it lies in: 2 where it is in the
    /// second triangle of cells divided down, and 1 more where it is in the second of those divided
    /// up.
    size_t quarter;

    PlainPosition() = default;
    HWY_INLINE PlainPosition(float x, float y) {
        const auto place = [](const DividedWeights<OneLane>& w, float b[3]) HWY_ATTR {
            b[0] = hn::GetLane(w.b0.v), b[1] = hn::GetLane(w.b1.v), b[2] = hn::GetLane(w.b2.v);
            return !(hn::GetLane(w.d.v) < 0);
        };
        const bool second_down = place(DividedWeights<OneLane>::down(OneLane(x), OneLane(y)), down);
        const bool second_up = place(DividedWeights<OneLane>::up(OneLane(x), OneLane(y)), up);
        quarter = size_t(second_down) * 2 + size_t(second_up);
    }
};

/// The positions of a cell, row by row, and the quarters that they lie in.
struct PlainPositions {
    PlainPosition positions[most_phases * LocatedBlock::most_rows];
    int count = 0;
    bool in_quarter[4] = {};

    HWY_INLINE PlainPositions(const float* x, int columns, const float* y, int rows) {
        for (int r = 0; r < rows; ++r)
            for (int k = 0; k < columns; ++k) {
                positions[count] = PlainPosition(x[k], y[r]);
                in_quarter[positions[count++].quarter] = true;
            }
    }
};

/// Neighbouring cells, one after the other in the lanes, however each is divided.
template <bool quadratic, bool soft, class T>
struct PlainCells {
    PlainCell<T> cell;
    T is_down; ///< 1 or 0

    HWY_INLINE PlainCells(const CellNumbers& values, const CellNumbers& softness, ptrdiff_t at,
                          T is_down_)
        : is_down(is_down_) {
        cell.template load<quadratic, soft>(values, softness, at,
                                            [](const float* p) HWY_ATTR { return T::load(p); });
    }

    HWY_INLINE T either(T if_down, T if_up) const {
        return if_less(T(0.0f), is_down, if_down, if_up);
    }
    /// The triangles that the positions of a quarter lie in.
    template <bool tame>
    HWY_INLINE void choose(const Patch<T>& if_down, const Patch<T>& if_up, T strict,
                           bool all_strict, Patch<T>& p) const {
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
        p.template find_range<soft, tame>(strict, all_strict);
    }
    template <bool tame>
    HWY_INLINE void find_quarters(const bool wanted[4], T strict, bool all_strict,
                                  Patch<T> quarter[4]) const {
        Patch<T> down[2], up[2];
        cell.template divide_down<soft>(down[0], down[1]);
        cell.template divide_up<soft>(up[0], up[1]);
        if (wanted[0])
            choose<tame>(down[0], up[0], strict, all_strict, quarter[0]);
        if (wanted[1])
            choose<tame>(down[0], up[1], strict, all_strict, quarter[1]);
        if (wanted[2])
            choose<tame>(down[1], up[0], strict, all_strict, quarter[2]);
        if (wanted[3])
            choose<tame>(down[1], up[1], strict, all_strict, quarter[3]);
    }

    /// The surface at a position.
    template <bool tame>
    HWY_INLINE T at(const PlainPosition& p, const Patch<T> quarter[4]) const {
        return quarter[p.quarter].template at<quadratic, soft, tame>(
            either(T(p.down[0]), T(p.up[0])), either(T(p.down[1]), T(p.up[1])),
            either(T(p.down[2]), T(p.up[2])));
    }
};

/// Hands out what cells, one after the other in the lanes, have at their positions.
class Shuffle {
public:
    /// phases: positions in a row of a cell; each has `count` of `channels` floats.
    HWY_INLINE Shuffle(int phases, int count, int channels)
        : m_phases(phases), m_count(count), m_channels(channels),
          m_cells(int(hn::Lanes(RowTag())) / count) {
        const int lanes = int(hn::Lanes(RowTag()));
        m_vectors = (m_cells * phases * count + lanes - 1) / lanes;
        float phase_of[most_phases * most_row_lanes];
        for (int i = 0; i < m_vectors * lanes; ++i) {
            const int pixel = i / count, cell = std::min(pixel / phases, m_cells - 1),
                      phase = pixel % phases, lane = cell * count + i % count;
            m_lane[i] = lane;
            phase_of[i] = float(phase);
        }
        const RowTag d;
        for (int j = 0; j < m_vectors; ++j)
            for (int k = 0; k < phases; ++k)
                m_here[j][k] = hn::Eq(hn::LoadU(d, phase_of + j * lanes), hn::Set(d, float(k)));
    }
    int cells() const { return m_cells; } ///< in a vector

    /// f: a vector a phase. room: floats there are from `to` on.
    template <int phases>
    HWY_INLINE void store(const RowLanes* f, ptrdiff_t room, float* to) const {
        const RowTag d;
        const hn::RebindToSigned<RowTag> di;
        const ptrdiff_t lanes = hn::Lanes(d);
        if (m_channels != m_count)
            return store_pixels(f, to);
        for (int j = 0; j < m_vectors; ++j) {
            const auto lane = hn::IndicesFromVec(d, hn::Load(di, m_lane + j * lanes));
            RowLanes v = hn::TableLookupLanes(f[0].v, lane);
            for (int k = 1; k < phases; ++k)
                v = hn::IfThenElse(m_here[j][k], hn::TableLookupLanes(f[k].v, lane), v.v);
            const ptrdiff_t left = room - j * lanes;
            if (left >= lanes) {
                v.store(to + j * lanes);
            } else {
                HWY_ALIGN float last[most_row_lanes];
                v.store(last);
                std::copy_n(last, left, to + j * lanes);
            }
        }
    }

private:
    HWY_INLINE void store_pixels(const RowLanes* f, float* to) const {
        HWY_ALIGN float lanes[most_row_lanes + most_in_pixel];
        for (int k = 0; k < m_phases; ++k) {
            f[k].store(lanes);
            for (int cell = 0; cell < m_cells; ++cell)
                store_pixel(PixelLanes::load(lanes + cell * m_count), m_count,
                            to + ptrdiff_t(cell * m_phases + k) * m_channels);
        }
    }

    int m_phases, m_count, m_channels, m_cells, m_vectors;
    HWY_ALIGN int32_t m_lane[most_phases * most_row_lanes];
    hn::Mask<RowTag> m_here[most_phases][most_phases]; ///< where vector j has phase k
};

/// Where results go.
struct Rows {
    float* first;     ///< the first position of the cells
    size_t row;       ///< floats from a row to the next
    ptrdiff_t floats; ///< that may be written in a row
};

template <int phases, bool quadratic, bool soft>
HWY_INLINE void evaluate_cells(const Net& whole, const LocatedBlock& block,
                               const Columns::Alike& alike, const PlainPositions& positions,
                               const Shuffle& shuffle, const Rows& out, int channels) {
    using T = RowLanes;
    const NetView net(whole);
    const int first_site = 2 * (block.cell_row * whole.stride + alike.cell), count = int(net.count);
    const CellNumbers values(net, net.values, first_site);
    CellNumbers softness;
    if (soft)
        softness = CellNumbers(net, net.soft, first_site);
    const T strict = ChannelLanes(whole.strict, count).at<T>({0, 0, 0});
    const bool all_strict =
        std::all_of(whole.strict, whole.strict + count, [](float lane) { return lane > 0; });
    Patch<T> quarter[4];
    T f[phases];
    for (int done = 0; done < alike.cells; done += shuffle.cells()) {
        const int x = std::min(done, alike.cells - shuffle.cells());
        const RowPlace place{ptrdiff_t(x) * count, x, 0};
        const PlainCells<quadratic, soft, T> cells(values, softness, place.at,
                                                   spread<T>(block.down.data(), place, count));
        const ptrdiff_t at = ptrdiff_t(x) * phases * channels;
        const auto each_row = [&](auto tame) HWY_ATTR {
            constexpr bool is_tame = decltype(tame)::value;
            cells.template find_quarters<is_tame>(positions.in_quarter, strict, all_strict,
                                                  quarter);
            const PlainPosition* p = positions.positions;
            float* to = out.first + at;
            for (int r = 0; r < block.count; ++r, to += out.row) {
                for (int k = 0; k < phases; ++k, ++p)
                    f[k] = cells.template at<is_tame>(*p, quarter);
                shuffle.store<phases>(f, out.floats - at, to);
            }
        };
        if (cells.cell.is_tame())
            each_row(std::true_type());
        else
            each_row(std::false_type());
    }
}

HWY_ATTR void evaluate_phases(const Net& net, Surface surface, const Columns& columns,
                              const LocatedBlock& block, int channels, int first, int count,
                              float* out, size_t row) {
    const Columns::Alike& alike = columns.alike;
    const PlainPositions positions(columns.x.data() + alike.begin, alike.phases, block.y,
                                   block.count);
    const Shuffle shuffle(alike.phases, count, channels);
    const Rows rows{out + size_t(alike.begin) * size_t(channels) + first, row,
                    ptrdiff_t(columns.count - alike.begin) * channels};
    for_surface(net, surface, [&](auto quadratic, auto soft) HWY_ATTR {
        constexpr bool q = decltype(quadratic)::value, s = decltype(soft)::value;
        static_assert(least_phases == 2 && most_phases == 4, "the cases");
        if (alike.phases == 2)
            evaluate_cells<2, q, s>(net, block, alike, positions, shuffle, rows, channels);
        else if (alike.phases == 3)
            evaluate_cells<3, q, s>(net, block, alike, positions, shuffle, rows, channels);
        else
            evaluate_cells<4, q, s>(net, block, alike, positions, shuffle, rows, channels);
    });
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(evaluate_phases);

void evaluate_phases(const Net& net, Surface surface, const Columns& columns,
                     const LocatedBlock& block, int channels, int first, int count, float* out,
                     size_t row) {
    HWY_DYNAMIC_DISPATCH(evaluate_phases)
    (net, surface, columns, block, channels, first, count, out, row);
}

} // namespace ddt
#endif
