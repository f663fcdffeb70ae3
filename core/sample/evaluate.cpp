// SPDX-License-Identifier: Apache-2.0
#include "core/sample/evaluate.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/base/arith.h"
#include "core/base/vectors/row_lanes.h"
#include "core/sample/evaluate_crossed.h"
#include "core/sample/evaluate_phases.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sample/evaluate.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/crossed_cell-inl.h"
#include "core/surface/patch-inl.h"

#include "core/base/vectors/blocks-inl.h"
#include "core/base/vectors/row_lanes-inl.h"

#include "core/surface/crossing-inl.h"
#include "core/surface/for_surface-inl.h"

/// Stores blocks, a position each, of a row or of some rows.
struct BlockStore {
    float* to[LocatedBlock::most_rows]; ///< a row's first position, first channel of the group
    int channels = 0, count = 0;
    /// All lanes may be stored: what is too much is overwritten by what follows.
    bool whole = false;
    /// Lane i of a packed vector, one with no gaps between its blocks' channels, is lane packed[i].
    HWY_ALIGN int32_t packed[row_padding];

    BlockStore(const GroupOutput& group, int rows)
        : channels(group.channels), count(group.count), whole(group.channels <= group_size) {
        for (int r = 0; r < rows; ++r)
            to[r] = group.at(0) + size_t(r) * group.row;
        const int lanes = int(hn::Lanes(D()));
        for (int i = 0; i < lanes; ++i)
            packed[i] = (i / count * group_size + i % count) % lanes;
    }

    /// Blocks of positions i, i + 1, ... before end of row r.
    HWY_INLINE void store(Blocks f, int i, int end, int r = 0) const {
        const D d;
        const hn::RebindToSigned<D> di;
        float* p = to[r] + size_t(i) * size_t(channels);
        if (whole) {
            if (channels < group_size)
                f = hn::TableLookupLanes(f.v, hn::IndicesFromVec(d, hn::Load(di, packed)));
            f.store(p);
            return;
        }
        HWY_ALIGN float lanes[row_padding];
        f.store(lanes);
        const int blocks = blocks_in_vector();
        for (int k = 0; k < blocks && i + k < end; ++k)
            for (int c = 0; c < count; ++c)
                p[k * channels + c] = lanes[k * group_size + c];
    }

    /// n positions' blocks, from position i of row r on, and nothing else.
    HWY_INLINE void store_exactly(const float* blocks, int n, int i, int r) const {
        float* p = to[r] + size_t(i) * size_t(channels);
        for (int k = 0; k < n; ++k)
            store_pixel(PixelLanes::load(blocks + k * group_size), count, p + k * channels);
    }
};

template <bool quadratic, bool soft, bool all_finite>
HWY_INLINE void evaluate_patch(Patch<Blocks>& patch, Bounds bounds, const LocatedRow& row,
                               const Span& span, const BlockStore& out, int r) {
    patch.template find_range<all_finite>(bounds);
    for (int i = span.begin; i < span.end; i += blocks_in_vector())
        out.store(patch.template at<quadratic, soft, all_finite>(spread(row.weight[0].data() + i),
                                                                 spread(row.weight[1].data() + i),
                                                                 spread(row.weight[2].data() + i)),
                  i, span.end, r);
}

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_triangle(const NetView& net, Bounds bounds, const LocatedRow& row,
                                  const Span& span, const BlockStore& out, int r = 0) {
    Patch<Blocks> patch;
    load_patch<quadratic, soft>(net, span.vertex, span.edge, patch);
    if (patch.is_surely_finite())
        evaluate_patch<quadratic, soft, true>(patch, bounds, row, span, out, r);
    else
        evaluate_patch<quadratic, soft, false>(patch, bounds, row, span, out, r);
}

/// What a net has round a row of cells.
struct NetCells {
    CellNumbers values, softness;
    HWY_INLINE NetCells(const NetView& net, bool soft, int site) : values(net, net.values, site) {
        if (soft)
            softness = CellNumbers(net, net.soft, site);
    }
};

/// Call each(evaluator) with what evaluates the divided cell at x, y.
template <bool quadratic, bool soft, bool down, bool all_finite, class Each>
HWY_INLINE void with_divided(PlainCell<Blocks>& cell, Bounds bounds, Each&& each) {
    cell.template find_ranges<all_finite>(bounds);
    each([&](Blocks x, Blocks y) HWY_ATTR {
        return down ? cell.template at_down<quadratic, soft, all_finite>(x, y)
                    : cell.template at_up<quadratic, soft, all_finite>(x, y);
    });
}

/// Call each(evaluator) with what evaluates the plain cell, divided by one of its diagonals, at x,
/// y.
template <bool quadratic, bool soft, bool down, class Each>
HWY_INLINE void with_cell(const NetCells& net, Bounds bounds, ptrdiff_t at, Each&& each) {
    PlainCell<Blocks> cell;
    cell.template load<quadratic, soft>(net.values, net.softness, at, in_every_block);
    if (down)
        cell.template divide_down<soft>(cell.first, cell.second);
    else
        cell.template divide_up<soft>(cell.first, cell.second);
    if (cell.is_surely_finite())
        with_divided<quadratic, soft, down, true>(cell, bounds, each);
    else
        with_divided<quadratic, soft, down, false>(cell, bounds, each);
}
template <bool quadratic, bool soft, class Each>
HWY_INLINE void with_cell(const NetCells& net, Bounds bounds, Span::Kind kind, ptrdiff_t at,
                          Each&& each) {
    if (kind == Span::cell_down)
        with_cell<quadratic, soft, true>(net, bounds, at, each);
    else
        with_cell<quadratic, soft, false>(net, bounds, at, each);
}

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_cell(const NetView& net, Bounds bounds, const LocatedRow& row,
                              const Span& span, const BlockStore& out) {
    const int step = blocks_in_vector();
    const float *x = row.weight[0].data(), *y = row.weight[1].data();
    const NetCells cell(net, soft, span.vertex[0]);
    with_cell<quadratic, soft>(cell, bounds, span.kind, 0, [&](auto&& at) HWY_ATTR {
        for (int i = span.begin; i < span.end; i += step)
            out.store(at(spread(x + i), spread(y + i)), i, span.end);
    });
}

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_spans(const ControlNet& whole, const LocatedRow& row,
                               const BlockStore& out) {
    const NetView net(whole);
    const Bounds bounds = whole.bounds;
    for (const Span& span : row.spans)
        if (span.kind == Span::triangle)
            evaluate_triangle<quadratic, soft>(net, bounds, row, span, out);
        else
            evaluate_cell<quadratic, soft>(net, bounds, row, span, out);
}

/// The positions of a block that lie in a plain cell. place: as CellNumbers has it.
template <bool quadratic, bool soft>
HWY_INLINE void evaluate_plain_cell(const NetCells& cells, ptrdiff_t place, Bounds bounds,
                                    const Columns& columns, const LocatedBlock& block,
                                    const LocatedBlock::Range& range, const BlockStore& out) {
    const int step = blocks_in_vector();
    with_cell<quadratic, soft>(cells, bounds, range.kind, place, [&](auto&& at) HWY_ATTR {
        for (int i = range.begin; i < range.end; i += step) {
            const Blocks x = spread(columns.x.data() + i);
            for (int r = 0; r < block.count; ++r)
                out.store(at(x, Blocks(block.y[r])), i, range.end, r);
        }
    });
}

/// Those in a crossed cell whose triangles are known. positions: kept from one cell to the next.
template <bool quadratic, bool soft>
HWY_INLINE void evaluate_crossed_cell(const NetView& net, Bounds bounds, const Columns& columns,
                                      const LocatedBlock& block, const LocatedBlock::Range& range,
                                      const BlockStore& out, CellPositions& positions,
                                      float* values) {
    const int n = range.end - range.begin;
    positions.set(columns.x.data() + range.begin, n, block.y, block.count);
    const CrossingTriangle* first = block.crossing.data() + range.triangle;
    for (const CrossingTriangle* t = first; t < first + range.triangles; ++t)
        evaluate_crossing<quadratic, soft>(net, bounds, *t, positions, values);
    for (int r = 0; r < block.count; ++r)
        out.store_exactly(values + r * n * group_size, n, range.begin, r);
}

/// Those in crossed cells that were located row by row. next_span: of each row the first span that
/// was not evaluated yet.
template <bool quadratic, bool soft>
HWY_INLINE void evaluate_range_in_rows(const NetView& net, Bounds bounds, const LocatedBlock& block,
                                       const LocatedBlock::Range& range, const BlockStore& out,
                                       size_t* next_span) {
    for (int r = 0; r < block.count; ++r) {
        const LocatedRow& located = block.rows[r];
        size_t& s = next_span[r];
        for (; s < located.spans.size() && located.spans[s].begin < range.end; ++s)
            evaluate_triangle<quadratic, soft>(net, bounds, located, located.spans[s], out, r);
    }
}

/// A block's ranges. What is stored too much is overwritten by the range to the right, except
/// before what evaluate_phases() made and at the end of a row: there stands what is not the
/// block's. What evaluate_crossed() makes comes last.
template <bool quadratic, bool soft>
HWY_INLINE void evaluate_ranges(const ControlNet& whole, const Columns& columns,
                                const LocatedBlock& block, BlockStore out) {
    const bool one_group = out.whole;
    const int phases_end = block.phases ? columns.alike.end() : 0;
    size_t next_span[LocatedBlock::most_rows] = {};
    const NetView net(whole);
    const Bounds bounds = whole.bounds;
    const int first_site = 2 * block.cell_row * whole.stride;
    const NetCells cells(net, soft, first_site);
    const ptrdiff_t first_cell = net.place(first_site);
    CellPositions positions;
    HWY_ALIGN float values[CellPositions::most * group_size + row_padding];
    for (const LocatedBlock::Range& range : block.ranges) {
        out.whole = one_group && range.end > phases_end &&
                    (columns.count - range.end) * out.channels >= row_padding;
        if (range.is_cell())
            evaluate_plain_cell<quadratic, soft>(cells, net.place(range.site) - first_cell, bounds,
                                                 columns, block, range, out);
        else if (range.has_triangles())
            evaluate_crossed_cell<quadratic, soft>(net, bounds, columns, block, range, out,
                                                   positions, values);
        else
            evaluate_range_in_rows<quadratic, soft>(net, bounds, block, range, out, next_span);
    }
}

HWY_ATTR void evaluate_row(const ControlNet& net, Surface surface, const LocatedRow& row,
                           const GroupOutput& to) {
    const BlockStore out(to, 1);
    for_surface(net, surface, [&](auto quadratic, auto soft) HWY_ATTR {
        evaluate_spans<decltype(quadratic)::value, decltype(soft)::value>(net, row, out);
    });
}

HWY_ATTR void evaluate_block(const ControlNet& net, Surface surface, const Columns& columns,
                             const LocatedBlock& block, const GroupOutput& to) {
    const BlockStore out(to, block.count);
    for_surface(net, surface, [&](auto quadratic, auto soft) HWY_ATTR {
        evaluate_ranges<decltype(quadratic)::value, decltype(soft)::value>(net, columns, block,
                                                                           out);
    });
}

HWY_ATTR void add_to_mean(const float* last, size_t n, float share, float* mean) {
    using Floats = Lanes<hn::ScalableTag<float>>;
    const size_t step = hn::Lanes(hn::ScalableTag<float>());
    size_t i = 0;
    for (; i + step <= n; i += step)
        running_mean(Floats::load(mean + i), Floats::load(last + i), Floats(share)).store(mean + i);
    using One = Lanes<hn::CappedTag<float, 1>>;
    for (; i < n; ++i)
        running_mean(One::load(mean + i), One::load(last + i), One(share)).store(mean + i);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(evaluate_row);
HWY_EXPORT(evaluate_block);
HWY_EXPORT(add_to_mean);

namespace {

/// The vertex with the largest weight at position i, the first of equals.
int largest_vertex(const LocatedRow& row, const Span& span, int stride, int i) {
    float w[3];
    int vertex[3] = {span.vertex[0], span.vertex[1], span.vertex[2]};
    const float x = row.weight[0][size_t(i)], y = row.weight[1][size_t(i)];
    const int s = span.vertex[0];
    const auto set = [&](int v0, int v1, int v2, float w0, float w1, float w2) {
        vertex[0] = v0, vertex[1] = v1, vertex[2] = v2;
        w[0] = w0, w[1] = w1, w[2] = w2;
    };
    // The cases of PlainCell.
    const int s1 = s + 2, s2 = s + 2 * stride, s3 = s2 + 2;
    if (span.kind == Span::cell_down && x < y)
        set(s, s3, s2, 1 - y, x, y - x);
    else if (span.kind == Span::cell_down)
        set(s, s1, s3, 1 - x, x - y, y);
    else if (span.kind == Span::cell_up && x + y < 1)
        set(s, s1, s2, 1 - (x + y), x, y);
    else if (span.kind == Span::cell_up)
        set(s1, s3, s2, 1 - y, (x + y) - 1, 1 - x);
    else
        for (int k = 0; k < 3; ++k)
            w[k] = row.weight[k][size_t(i)];
    return vertex[w[1] > w[0] ? (w[2] > w[1] ? 2 : 1) : (w[2] > w[0] ? 2 : 0)];
}

/// Copy Channel::nearest values over what the vectors made of them.
void copy_nearest(const ControlNet& net, NearestMask nearest, int stride, const LocatedRow& row,
                  const GroupOutput& to) {
    for (const Span& span : row.spans)
        for (int i = span.begin; i < span.end; ++i) {
            const float* z = net.vertex(largest_vertex(row, span, stride, i));
            float* p = to.at(i);
            for (int c = 0; c < to.count; ++c)
                if (nearest & (1u << c))
                    std::memcpy(p + c, z + c, sizeof(float));
        }
}

} // namespace

void evaluate_row(const ControlNet& net, Surface surface, NearestMask nearest,
                  const LocatedRow& row, const GroupOutput& to) {
    HWY_DYNAMIC_DISPATCH(evaluate_row)(net, surface, row, to);
    if (nearest)
        copy_nearest(net, nearest, net.stride, row, to);
}

void evaluate_block(const ControlNet& net, Surface surface, const Columns& columns,
                    const LocatedBlock& block, const GroupOutput& to) {
    if (block.phases)
        evaluate_phases(net, surface, columns, block, to);
    HWY_DYNAMIC_DISPATCH(evaluate_block)(net, surface, columns, block, to);
    if (!block.crossed.cells.empty())
        evaluate_crossed(net, surface, columns, block, to);
}

void add_to_mean(const float* last, size_t n, float share, float* mean) {
    HWY_DYNAMIC_DISPATCH(add_to_mean)(last, n, share, mean);
}

} // namespace ddt
#endif
