// SPDX-License-Identifier: Apache-2.0
// Where a walk round a vertex begins: Lattice::find_first_edges() and its kin.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/lattice/crossed_columns.h"
#include "core/lattice/lattice.h"

namespace ddt {

namespace {

/// The order of addresses.
bool precedes(Vec a, Vec b) {
    return a.y < b.y || (a.y == b.y && a.x < b.x);
}

/// A vertex' neighbours, in the order of the addresses of the edges to them.
constexpr std::array<std::array<int, 2>, 8> neighbours{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// The first of a vertex' edges to its neighbours; zero: none. inside(x, y): whether there is such
/// a neighbour.
template <class Inside>
Vec first_short_edge(const Lattice& lattice, int vertex, Inside inside) {
    for (const auto& to : neighbours) {
        const Vec v(to[0], to[1]);
        if (!inside(to[0], to[1]))
            continue;
        const Vec there = lattice.edge(vertex + lattice.offset(v)).v;
        if (there == v || there == -v)
            return v;
    }
    return {};
}

} // namespace

void Lattice::find_first_edges(const Rect& part) {
    // No midpoint is further from its edge's ends, in doubled coordinates.
    const int x0 = std::max(2 * part.x0 - m_longest, 0), y0 = std::max(2 * part.y0 - m_longest, 0);
    const int x1 = std::min(2 * (part.x1 - 1) + m_longest, 2 * (m_width - 1)),
              y1 = std::min(2 * (part.y1 - 1) + m_longest, 2 * (m_height - 1));
    const auto look_at = [&](int m) {
        const Vec v = edge(m).v;
        const int to_b = offset(v);
        vertex(m - to_b).first = v;
        vertex(m + to_b).first = -v;
    };
    // Backwards: the smallest address is written last.
    for (int y = y1; y >= y0; --y)
        for (int column = x1 / 2; column >= x0 / 2; --column) {
            const int m = site(2 * column, y);
            if (column < m_width - 1)
                look_at(m + 1);
            if (y & 1) // on even rows there is a vertex
                look_at(m);
        }
}

void Lattice::find_walked_first_edges(const Rect& part) {
    find_short_first_edges(part);
    find_long_first_edges(part);
}

/// Fill Vertex::first as if no edge were longer than a diagonal; zero where all are.
void Lattice::find_short_first_edges(const Rect& part) {
    const auto anywhere = [](int, int) { return true; };
    const int begin = std::max(part.x0, 1), end = std::min(part.x1, m_width - 1);
    for (int y = part.y0; y < part.y1; ++y) {
        const bool rim = y == 0 || y == m_height - 1;
        const NearDivisions near(*this, y);
        const auto next = [&](int x) {
            return next_crossed(x, begin, rim ? begin : end,
                                [&](int at) { return near.crossed_beside(at); });
        };
        for (int x = next(part.x0); x < part.x1; x = next(x + 1)) {
            const int s = vertex_site(x, y);
            const auto inside = [&](int along, int down) {
                return unsigned(x + along) < unsigned(m_width) &&
                       unsigned(y + down) < unsigned(m_height);
            };
            const bool at_rim = rim || x == 0 || x == m_width - 1;
            vertex(s).first =
                at_rim ? first_short_edge(*this, s, inside) : first_short_edge(*this, s, anywhere);
        }
    }
}

/// Look at longer edges, whose midpoints are in the cells that they cross, or between two of them.
void Lattice::find_long_first_edges(const Rect& part) {
    const auto look_at = [&](int m) {
        const Vec v = edge(m).v;
        if (std::max(std::abs(v.x), std::abs(v.y)) <= 1)
            return;
        const auto add = [&](int end, Vec to) {
            Vec& first = vertex(end).first;
            if (first.zero() || precedes(to, first))
                first = to;
        };
        const int to_b = offset(v);
        add(m - to_b, v);
        add(m + to_b, -v);
    };
    // How far, in cells, midpoints are from the part at most; beyond the cells round the part it is
    // not known which are crossed.
    const int far = m_longest / 2 + 1;
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1, m_width - 1);
    const int x1 = std::min(part.x1 + far, m_width - 1), y1 = std::min(part.y1 + far, m_height - 1);
    for (int y = std::max(part.y0 - far, 0); y < y1; ++y) {
        const bool known = part.y0 - 1 <= y && y < part.y1;
        const Division* row = divisions(y);
        const auto next = [&](int x) {
            return next_crossed(x, begin, known ? end : begin,
                                [&](int at) { return crossed_cells(row + at); });
        };
        for (int x = next(std::max(part.x0 - far, 0)); x < x1; x = next(x + 1)) {
            const int upper_left = vertex_site(x, y);
            look_at(upper_left + 1);
            look_at(upper_left + m_stride);
            look_at(upper_left + m_stride + 1);
        }
    }
}

} // namespace ddt
