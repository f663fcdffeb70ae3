// Reading the surface at a row of positions.
#pragma once

#include <vector>

#include "core/sample/locate.h"
#include "core/surface/net.h"

namespace ddt {

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
    /// Pixels of the lattice that hold the vertices of all triangles met (not of plain cells) since
    /// forget().
    Rect reach;

    /// A triangle met in the row before, tried before one is searched for; `end` is where it ended.
    struct Hint {
        Triangle triangle;
        int end;
    };
    std::vector<Hint> hints, previous_hints;

    /// To be called before the first row of another lattice; `start` is a pixel of it.
    void forget(int start_x, int start_y) {
        reach = {start_x, start_y, start_x + 1, start_y + 1};
        hints.clear();
        previous_hints.clear();
    }
};

/// Locate n positions, neighbours within 2 pixels of each other.
void locate_row(const Lattice& lattice, const Point* points, int n, LocatedRow& row);

/// Which channels of a group are Channel::nearest, one bit each.
using NearestMask = unsigned;

/// Floats beyond the end of its row that evaluate_row() may write.
constexpr int row_padding = 16;

/// Evaluate a group's surface at a located row: `count` channels of position i go to
/// out[i * channels + first ...]. Up to row_padding floats after the row's last are overwritten.
///
/// Every value is clamped to the range of its triangle's vertices, which takes off the last bit of
/// rounding; a vertex with weight 0 contributes exactly nothing, even if it is not finite; NaN
/// results have the bits 0x7fc00000, zeros no sign.
void evaluate_row(const Net& net, Surface surface, NearestMask nearest, const LocatedRow& row,
                  int channels, int first, int count, float* out);

} // namespace ddt
