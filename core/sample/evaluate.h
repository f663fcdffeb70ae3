// Reading the surface at a row of positions.
#pragma once

#include <vector>

#include "core/sample/locate.h"
#include "core/surface/net.h"

namespace ddt {

/// A run of neighbouring positions of a row in one triangle.
struct Span {
    int vertex[3]; ///< sites, as in Triangle
    int edge[3];
    int begin, end;
};

/// The triangles and weights of a row of positions.
struct LocatedRow {
    std::vector<Span> spans;
    std::vector<float> weights; ///< three a position: exact multiples of 2^-16

    /// A triangle met in the row before, tried before one is searched for; `end` is where it ended.
    struct Hint {
        Triangle triangle;
        int end;
    };
    std::vector<Hint> hints, previous_hints;

    /// To be called before the first row of another lattice.
    void forget() {
        hints.clear();
        previous_hints.clear();
    }
};

/// Locate n positions, neighbours within 2 pixels of each other.
void locate_row(const Lattice& lattice, const Point* points, int n, LocatedRow& row);

/// Which channels of a group are Channel::nearest, one bit each.
using NearestMask = unsigned;

/// Evaluate a group's surface at a located row: `count` channels of position i go to
/// out[i * channels + first ...]. May write group_size floats there if they fit before
/// out + n * channels + group_size and count < group_size is the last group.
///
/// Every value is clamped to the range of its triangle's vertices, which takes off the last bit of
/// rounding; a vertex with weight 0 contributes exactly nothing, even if it is not finite; NaN
/// results have the bits 0x7fc00000.
void evaluate_row(const Net& net, Surface surface, NearestMask nearest, const LocatedRow& row,
                  int channels, int first, int count, float* out);

} // namespace ddt
