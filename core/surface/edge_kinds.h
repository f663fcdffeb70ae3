// SPDX-License-Identifier: Apache-2.0
// Regular edges: those between plain cells, whose ends and apexes lie alike along a row, so that
// they are worked on in vectors. Irregular edges: those at the rim, or in or beside a crossed cell;
// they are listed, and looked up one at a time.
#pragma once

#include <algorithm>

#include "core/lattice/crossed_columns.h"

namespace ddt {

/// Edges at or beside the vertices of a row of pixels: to the next vertex on the right or below, or
/// within the cell between.
enum class EdgeKind { horizontal, vertical, diagonal };

/// Whether their midpoints are in odd columns, or rows, of the doubled lattice.
constexpr bool in_odd_column(EdgeKind kind) {
    return kind != EdgeKind::vertical;
}
constexpr bool in_odd_row(EdgeKind kind) {
    return kind != EdgeKind::horizontal;
}

/// From the site of the row's first vertex to that of the edge in column 0.
template <EdgeKind kind>
int to_first(const Lattice& lattice) {
    return int(in_odd_column(kind)) + (in_odd_row(kind) ? lattice.stride() : 0);
}

/// List the columns from x0 to x1 - 1 whose edges of a kind, of row y of pixels, are irregular:
/// those outside begin .. end - 1 and those beside crossed cells. Returns how many; as many as
/// cells_at_once more may be written.
template <EdgeKind kind>
DDT_INLINE int list_irregular(const Lattice& lattice, int x0, int x1, int begin, int end, int y,
                              int* columns) {
    const NearDivisions divisions(lattice, y);
    const auto crossed = [&](int x) {
        const uint64_t here = crossed_cells(divisions.below + x);
        return kind == EdgeKind::horizontal ? here | crossed_cells(divisions.above + x)
               : kind == EdgeKind::vertical ? here | crossed_cells(divisions.below + x - 1)
                                            : here;
    };
    int n = 0;
    for (int x = x0; x < std::min(begin, x1); ++x)
        columns[n++] = x;
    n += list_crossed(begin, end, crossed, columns + n);
    for (int x = end; x < x1; ++x)
        columns[n++] = x;
    return n;
}

} // namespace ddt
