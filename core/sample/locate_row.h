// SPDX-License-Identifier: Apache-2.0
// The triangles or plain cells that positions lie in: of a row, or of a block of rows within one
// row of cells (evaluate.h says which serves when).
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vectors/row_lanes.h"
#include "core/lattice/crossed_cell.h"
#include "core/lattice/crossed_rows.h"
#include "core/lattice/locate.h"

namespace ddt {

/// Floats beyond the end of a row of positions that may be read or written.
constexpr int row_padding = most_lanes;

/// A run of neighbouring positions of a row that lie in one triangle, or in one cell that is
/// divided by its own diagonal: most are.
struct Span {
    enum Kind : int {
        triangle,
        cell_down, ///< diagonal from the cell's first corner to the opposite one
        cell_up,   ///< the other diagonal
    };
    Kind kind;
    int begin, end;
    int vertex[3]; ///< sites, as in Triangle; of a cell, [0] is its first corner
    int edge[3];
};

/// The triangles and weights of a row of positions.
struct LocatedRow {
    std::vector<Span> spans; ///< in order, without gaps
    /// Weights of the positions in spans of kind triangle; in cells the first two are the position
    /// relative to the cell's first corner. Exact multiples of 2^-16; padded to whole vectors.
    std::vector<float> weight[3];
};

/// What is remembered from row to row while one lattice's positions are located.
struct Search {
    /// A triangle met in the row before, tried before one is searched for; `end` is where it ended.
    struct Hint {
        Triangle triangle;
        int end = 0;
        explicit Hint(const Triangle& met) : triangle(met) {}
        // Made in its place: a copy would wait for what was just stored.
        Hint(const Lattice& lattice, Point p) : triangle(locate(lattice, p)) {}
    };
    std::vector<Hint> hints, previous_hints;

    /// To be called before the first row of another lattice.
    void begin() {
        hints.clear();
        previous_hints.clear();
    }
};

/// Locate n positions, neighbours within 2 pixels of each other. Here and below, the lattice's
/// divisions must have been found.
void locate_row(const Lattice& lattice, const Point* points, int n, Search& search,
                LocatedRow& row);

/// Positions in a cell, along x, that evaluate_phases() (evaluate_phases.h) can be asked for.
constexpr int least_phases = 2, most_phases = 4;
/// Where the positions of all rows lie along x, for mappings whose axes are independent.
struct Columns {
    /// Positions begin .. end - 1 lie in the cells with this first corner.
    struct Run {
        int cell, begin, end;
    };
    std::vector<Run> runs;
    std::vector<float> x; ///< relative to the cell's first corner; padded to whole vectors
    int count = 0;        ///< of positions

    /// Neighbouring cells whose positions lie alike in each: so they do in all but a picture's
    /// first and last where it is enlarged a whole number of times.
    struct Alike {
        int cell = 0, cells = 0; ///< the first, and how many; 0: none
        int begin = 0;           ///< the first position
        int phases = 0;          ///< positions in a cell; those of the first are x[begin] and on
        int end() const { return begin + cells * phases; }
    };
    Alike alike;

    /// Of n positions in ascending order, on a lattice of `width` pixels.
    void find(const Point* points, int n, int width);

private:
    void find_alike();
};

/// The triangles and weights of neighbouring rows of positions within one row of cells. What cells
/// need is found once for all rows.
struct LocatedBlock {
    static constexpr int most_rows = 8;

    /// Neighbouring columns: either of one plain cell, or of one crossed cell whose triangles were
    /// found, or of crossed cells with more positions than CellPositions has, whose spans are in
    /// `rows`.
    struct Range {
        Span::Kind kind; ///< of a plain cell how it is divided, else triangle
        int begin, end;
        int site;                        ///< of the first cell's first corner
        int triangle = 0, triangles = 0; ///< the crossed cell's: the first in `crossing`, how many

        bool is_cell() const { return kind != Span::triangle; }
        bool has_triangles() const { return triangles > 0; }
        bool is_in_rows() const { return !is_cell() && !has_triangles(); }
    };
    std::vector<Range> ranges; ///< in order, without gaps but where `phases` or `crossed` has cells
    /// evaluate_phases() makes Columns::alike, most of which are plain.
    bool phases = false;
    std::vector<float> down; ///< of these 1 where the diagonal is down, else 0; padded to vectors
    int cell_row = 0;        ///< the row of cells
    int count = 0;           ///< of rows
    float y[most_rows];      ///< the rows' positions relative to the cells' first corners
    std::vector<CrossingTriangle> crossing; ///< of the crossed cells that ranges are of
    /// The crossed cells of Columns::alike: evaluate_crossed() makes them.
    CrossedRows::Row crossed;
    LocatedRow rows[most_rows]; ///< spans of the ranges that are in rows
};

/// Locate rows of positions until the row of cells ends, at most LocatedBlock::most_rows: those at
/// y[0], y[1], ... y[n - 1] (ascending) and the x of `points`, whose y is overwritten. `columns` is
/// what find() made of `points`. Returns the rows located, at least 1.
int locate_block(const Lattice& lattice, const Columns& columns, std::vector<Point>& points,
                 const int32_t* y, int n, Search& search, LocatedBlock& block);

} // namespace ddt
