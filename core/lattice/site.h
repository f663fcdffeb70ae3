// SPDX-License-Identifier: Apache-2.0
// What a lattice has at a site: an edge or a vertex, and how they are kept in 8 bytes; and how a
// cell is divided, told by the edge at its centre. lattice.h tells what a lattice is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/arith.h"
#include "core/base/float_bits.h"

namespace ddt {

/// A vector in doubled coordinates, or in pixels where that is said.
struct Vec {
    int8_t x = 0, y = 0;
    Vec() = default;
    Vec(int x_, int y_) : x(int8_t(x_)), y(int8_t(y_)) {}
    bool operator==(Vec o) const { return x == o.x && y == o.y; }
    bool operator!=(Vec o) const { return !(*this == o); }
    Vec operator-() const { return {-x, -y}; }
    Vec operator+(Vec o) const { return {x + o.x, y + o.y}; }
    Vec operator-(Vec o) const { return {x - o.x, y - o.y}; }
    bool zero() const { return x == 0 && y == 0; }
};

/// A vector's two bytes, x in the low one, and back.
constexpr uint32_t bytes_of(int x, int y) {
    return uint32_t((x & 255) | (y & 255) << 8);
}
inline Vec vec_of(uint32_t bytes) {
    return {int8_t(bytes & 255), int8_t(bytes >> 8 & 255)};
}

/// Of a vector with even coordinates.
inline Vec half(Vec v) {
    return {v.x / 2, v.y / 2};
}
/// 1 in the coordinates that are odd, or even, else 0.
inline Vec odd(Vec v) {
    return {v.x & 1, v.y & 1};
}
inline Vec even(Vec v) {
    return {1 - (v.x & 1), 1 - (v.y & 1)};
}

/// v.x * w.y - v.y * w.x
inline int det(Vec v, Vec w) {
    return v.x * w.y - v.y * w.x;
}

/// What tells an edge that cannot be flipped, in the upper half of Edge::word. As a float such a
/// word is less than no_gain.
constexpr uint32_t rigid_mark = 0xff7f;
/// Edge::word of an edge that can be flipped while its gain is about to be found: minus infinity.
constexpr uint32_t touched_word = 0xff800000u;
/// Both are at least this, and the words of gains are less.
constexpr uint32_t least_unsettled = rigid_mark << 16;
/// Stored gains are at least this, and NaN is stored with its sign clear: smaller floats and NaN
/// with a sign have words that encode rigid_mark and touched_word, or that settled() takes for
/// them.
constexpr float least_gain = -1e38f;

/// An edge with midpoint m, ends a = m - v and b = m + v; vectors in doubled coordinates, which
/// makes v also b - a in pixels. Apexes are relative to m; a zero apex: none, the hull's rim.
///
/// An edge can be flipped if it is the diagonal of a parallelogram, which makes one apex the
/// opposite of the other, and its flipped state is no longer than longest_edge. So of an edge
/// either its gain is told or its right apex.
struct Edge {
    Vec v;
    Vec left;
    /// Of an edge that can be flipped its gain as a float, of others rigid_mark above the bytes of
    /// the right apex.
    uint32_t word = 0;

    Edge() = default;
    /// With a gain that is not known, which is told by no_gain.
    Edge(Vec v_, Vec left_, Vec right) : v(v_), left(left_) {
        if (is_diagonal(left_, right))
            set_gain(no_gain);
        else
            word = rigid_mark << 16 | bytes_of(right.x, right.y);
    }

    bool flippable() const { return word >> 16 != rigid_mark; }
    Vec right() const { return flippable() ? -left : vec_of(word); }
    /// The sum of both apexes: zero of an edge that can be flipped.
    Vec apexes() const { return left + right(); }

    /// no_gain of an edge that cannot be flipped, or whose gain is not known.
    float gain() const { return std::max(float_of(word), no_gain); }
    /// Of an edge that can be flipped.
    void set_gain(float gain) {
        gain = gain < least_gain ? least_gain : gain;
        word = bits_of(gain != gain ? std::fabs(gain) : gain);
    }

    /// Whether an edge with these apexes can be flipped. Without branches, since half of all can.
    static bool is_diagonal(Vec left, Vec right) {
        const auto allowed = [](int n) { return unsigned(n + longest_edge) <= 2u * longest_edge; };
        return ((left.x | left.y) != 0) & (left.x + right.x == 0) & (left.y + right.y == 0) &
               allowed(left.x) & allowed(left.y);
    }
};

/// How a cell (2x2 pixels) is divided, told by the edge at its centre.
/// A cell divided in two is called plain.
enum class Division : uint8_t {
    down = division_down,       ///< in two, by the diagonal from upper left to lower right
    up = division_up,           ///< in two, by the other diagonal
    crossed = division_crossed, ///< edges that are not the cell's own cross it
};
static_assert(sizeof(Division) == 1 && int(Division::down) == 0 && int(Division::up) == 1 &&
                  int(Division::crossed) == 2,
              "stored, counted with, and told by a bit");

/// v and left of an edge's record as one number.
constexpr uint32_t first_word(int vx, int vy, int left_x, int left_y) {
    return bytes_of(vx, vy) | bytes_of(left_x, left_y) << 16;
}
inline uint32_t first_word(const Edge& e) {
    return first_word(e.v.x, e.v.y, e.left.x, e.left.y);
}

/// An edge's vectors as one number: v in the low two bytes, then left, then right; the record of
/// an edge as shaders have it (shaders/lattice.glsl).
inline uint64_t vectors_of(const Edge& e) {
    const Vec right = e.right();
    return first_word(e) | uint64_t(bytes_of(right.x, right.y)) << 32;
}
/// The bits of a shader's record that are those; the others are scratch.
constexpr uint64_t vectors_mask = 0xffffffffffffu;

/// First words of the central edge of a cell that its own diagonal divides, which can always be
/// flipped: the apexes are the cell's other corners, and the edge may run either way.
constexpr uint32_t down_word = first_word(1, 1, -1, 1), down_word_back = first_word(-1, -1, 1, -1),
                   up_word = first_word(-1, 1, -1, -1), up_word_back = first_word(1, -1, 1, 1);

/// The division of the cell that `centre` is the central edge of.
inline Division division(const Edge& centre) {
    const uint32_t first = first_word(centre);
    const bool down = centre.flippable() & ((first == down_word) | (first == down_word_back));
    const bool up = centre.flippable() & ((first == up_word) | (first == up_word_back));
    return Division(2 - 2 * int(down) - int(up));
}

struct Vertex {
    float guide = 0;
    union {
        /// While edges flip: the contour word (core/guide/contour.h) of the cell that has this as
        /// its upper left corner.
        uint32_t contour = 0;
        /// Afterwards: midpoint of the incident edge with the smallest address, relative to the
        /// vertex.
        Vec first;
    };
};

union Site {
    Edge edge;
    Vertex vertex;
    Site() : edge() {}
};
static_assert(sizeof(Site) == 8 && sizeof(Edge) == 8, "one edge, 8 bytes");

} // namespace ddt
