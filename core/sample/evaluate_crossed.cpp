// SPDX-License-Identifier: Apache-2.0
#include "core/sample/evaluate_crossed.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/base/arith.h"
#include "core/base/vectors/row_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sample/evaluate_crossed.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/crossed_cell-inl.h"
#include "core/surface/for_surface-inl.h"
#include "core/surface/patch-inl.h"

#include "core/base/vectors/blocks-inl.h"
#include "core/base/vectors/row_lanes-inl.h"

#include "core/surface/triangle_numbers-inl.h"

#include "core/surface/crossed_cells-inl.h"

/// Stores the values of one cell.
struct CellStore {
    float* first; ///< the first position of the first cell
    size_t row;   ///< floats from a row to the next
    int channels, count;

    /// n neighbouring pixels of a row, and nothing else.
    HWY_INLINE void store(const float* pixels, int n, float* to) const {
        // What is stored too much is overwritten by the pixels to the right.
        const int whole = channels == count ? n - (most_in_pixel - 1) / count : 0;
        int i = 0;
        for (; i < whole; ++i)
            PixelLanes::load(pixels + i * most_in_pixel).store(to + i * count);
        for (; i < n; ++i)
            store_pixel(PixelLanes::load(pixels + i * most_in_pixel), count, to + i * channels);
    }
};

/// The positions of neighbouring lanes, a pixel each.
template <class Values>
HWY_INLINE void to_pixels(const Values& f, int used, float* pixels) {
    const RowTag d;
    for (int at = 0; at < used; at += int(hn::Lanes(d)))
        hn::StoreInterleaved4(hn::LoadU(d, f[0] + at), hn::LoadU(d, f[1] + at),
                              hn::LoadU(d, f[2] + at), hn::LoadU(d, f[3] + at), d,
                              pixels + at * most_in_pixel);
}

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_cells(const ControlNet& net, const Columns::Alike& alike,
                               const LocatedBlock& block, const PositionLanes& lanes,
                               const CellStore& out) {
    CrossedCells<quadratic, soft> crossed(net, 2 * block.cell_row * net.stride, lanes);
    using Values = typename CrossedCells<quadratic, soft>::Values;
    HWY_ALIGN float pixels[PositionLanes::most * most_in_pixel];
    const CrossedRows::Cell* const cells = block.crossed.cells.data();
    crossed.each(cells, cells + block.crossed.cells.size(), block.crossed.triangles.data(),
                 [&](const CrossedRows::Cell* cell, int n, const Values& f) HWY_ATTR {
                     to_pixels(f, lanes.used(), pixels);
                     const float* p = pixels;
                     for (int k = 0; k < n; ++k) {
                         float* to = out.first + ptrdiff_t(cell[k].x - alike.cell) * alike.phases *
                                                     out.channels;
                         for (int r = 0; r < block.count; ++r, to += out.row) {
                             out.store(p, alike.phases, to);
                             p += alike.phases * most_in_pixel;
                         }
                     }
                 });
}

HWY_ATTR void evaluate_crossed(const ControlNet& net, Surface surface, const Columns& columns,
                               const LocatedBlock& block, const GroupOutput& to) {
    const Columns::Alike& alike = columns.alike;
    CellPositions positions;
    positions.set(columns.x.data() + alike.begin, alike.phases, block.y, block.count);
    const PositionLanes lanes(positions, [](int i) { return i; });
    const CellStore out{to.at(alike.begin), to.row, to.channels, to.count};
    for_surface(net, surface, [&](auto quadratic, auto soft) HWY_ATTR {
        evaluate_cells<decltype(quadratic)::value, decltype(soft)::value>(net, alike, block, lanes,
                                                                          out);
    });
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(evaluate_crossed);

void evaluate_crossed(const ControlNet& net, Surface surface, const Columns& columns,
                      const LocatedBlock& block, const GroupOutput& to) {
    HWY_DYNAMIC_DISPATCH(evaluate_crossed)(net, surface, columns, block, to);
}

} // namespace ddt
#endif
