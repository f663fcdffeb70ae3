// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "core/guide/contour.h"
#include "core/lattice/crossed_columns.h"
#include "core/lattice/divisions.h"
#include "core/lattice/start_rows.h"

namespace ddt {

namespace {

Site edge_site(Vec v, Vec left, Vec right) {
    Site s;
    s.edge = Edge(v, left, right);
    return s;
}

// The edges of the starting mesh by how the cells beside them are divided: not 0 down, 0 up.

/// Horizontal, v = (1, 0): left (det > 0) is below.
Site horizontal(int above, int below, bool has_above, bool has_below) {
    return edge_site({1, 0}, has_below ? Vec(below ? 1 : -1, 2) : Vec(),
                     has_above ? Vec(above ? -1 : 1, -2) : Vec());
}

/// Vertical, v = (0, 1): left is towards smaller x.
Site vertical(int left, int right, bool has_left, bool has_right) {
    return edge_site({0, 1}, has_left ? Vec(-2, left ? -1 : 1) : Vec(),
                     has_right ? Vec(2, right ? 1 : -1) : Vec());
}

Site diagonal(int down) {
    return down ? edge_site({1, 1}, {-1, 1}, {1, -1}) : edge_site({-1, 1}, {-1, -1}, {1, 1});
}

/// Divide the n cells between two rows of the guide as Lattice::start() says.
void divide(const float* upper, const float* lower, const uint32_t* words, int n, bool flat,
            DownFlag* down) {
    if (!flat) {
        std::fill_n(down, n, diagonal_down);
        return;
    }
    for (int x = divide_flat(upper, lower, words, n, down); x < n; ++x) {
        const int xy = words ? contour_xy(words[x]) : 0;
        const bool differs_less =
            std::fabs(upper[x] - lower[x + 1]) <= std::fabs(upper[x + 1] - lower[x]);
        down[x] = (xy == 0 ? differs_less : xy < 0) ? diagonal_down : 0;
    }
}

} // namespace

float* Lattice::guide_place(int width, int height) {
    // At the end. start() goes down row by row: where n rows of pixels are left their sites take 32
    // n bytes a column and their guide 4 n, and where one is left its sites take 16 and end before
    // what was read of it.
    const size_t pixels = size_t(width) * size_t(height);
    m_sites.resize(4 * pixels);
    return reinterpret_cast<float*>(m_sites.data() + m_sites.size()) - pixels;
}

void Lattice::start(int width, int height, const float* guide, bool flat, bool contours) {
    m_width = width;
    m_height = height;
    m_stride = 2 * width;
    m_fresh = true;
    m_longest = 1;
    m_longest_down.resize(size_t(2 * height - 1));
    for (size_t y = 0; y < m_longest_down.size(); ++y)
        m_longest_down[y] = y & 1;
    m_sites.resize(size_t(m_stride) * size_t(2 * height - 1));
    const auto of_two = [](auto&& edge) {
        return RecordOfTwo(edge(0, 0), edge(0, 1), edge(1, 0), edge(1, 1));
    };
    const RecordOfTwo horizontals =
                          of_two([](int a, int b) { return horizontal(a, b, true, true); }),
                      verticals = of_two([](int a, int b) { return vertical(a, b, true, true); }),
                      diagonals = of_two([](int, int b) { return diagonal(b); });

    // How cells are divided: kept for two rows of them, since a horizontal edge has its apexes in
    // both.
    const int last = width - 1;
    std::optional<ContourRows> words;
    if (contours)
        words.emplace(guide, width, height);
    std::vector<DownFlag> above(size_t(width), 0), below(size_t(width), 0);
    for (int y = 0; y < height; ++y) {
        const float* z = guide + size_t(y) * size_t(width);
        const bool has_above = y > 0, has_below = y + 1 < height;
        const uint32_t* word = has_below && contours ? words->next() : nullptr;
        if (has_below)
            divide(z, z + width, word, last, flat, below.data());
        Site* even = m_sites.data() + site(0, 2 * y);
        int x = has_above && has_below
                    ? make_even_row(z, word, above.data(), below.data(), horizontals, last, even)
                    : 0;
        for (; x < last; ++x) {
            even[2 * x].vertex = Vertex{z[x], {word ? word[x] : 0}};
            even[2 * x + 1] = horizontal(above[size_t(x)], below[size_t(x)], has_above, has_below);
        }
        even[2 * last].vertex = Vertex{z[last], {0}};
        if (!has_below)
            break;
        Site* odd = m_sites.data() + site(0, 2 * y + 1);
        odd[0] = vertical(0, below[0], false, true);
        odd[1] = diagonal(below[0]);
        x = 1 + make_odd_row(below.data() + 1, verticals, diagonals, last - 1, odd + 2);
        for (; x < last; ++x) {
            odd[2 * x] = vertical(below[size_t(x) - 1], below[size_t(x)], true, true);
            odd[2 * x + 1] = diagonal(below[size_t(x)]);
        }
        odd[2 * last] = vertical(below[size_t(last) - 1], 0, true, false);
        above.swap(below);
    }
}

void Lattice::find_divisions(const Rect& part) {
    const int columns = m_width - 1;
    m_divisions.resize(size_t(columns) * size_t(m_height - 1) + cells_at_once);
    const int x0 = std::max(part.x0 - 1, 0), x1 = std::min(part.x1, columns);
    for (int y = std::max(part.y0 - 1, 0); y < std::min(part.y1, m_height - 1); ++y) {
        const size_t row = size_t(y) * size_t(columns);
        ddt::find_divisions(m_sites.data() + site(2 * x0 + 1, 2 * y + 1), x1 - x0,
                            m_divisions.data() + row + size_t(x0));
    }
}

void Lattice::flip(int m) {
    m_fresh = false;
    Edge& e = edge(m);
    const Quad q(e);
    const Vec c = e.left, d = -e.left;
    // Side ac loses apex b and gets d; cb: a -> d; bd: a -> c; da: b -> c.
    const Vec came[4] = {d, d, c, c};
    for (int k = 0; k < 4; ++k) {
        Edge& side = edge(m + offset(q.middle[k]));
        const Vec inner = came[k] - q.middle[k], beyond = apex_beyond(side, q.inner[k]);
        side = side.left == q.inner[k] ? Edge(side.v, inner, beyond) : Edge(side.v, beyond, inner);
    }
    e = Edge(c, -e.v, e.v);
    const int down = std::abs(int(c.y));
    m_longest = std::max({m_longest, std::abs(int(c.x)), down});
    if (down > 1) // start() knows of one row
        note_down(m, down);
}

void Lattice::flip_back(int m) {
    flip(m);
    // Flipped twice it runs the other way.
    Edge& e = edge(m);
    e = Edge(-e.v, e.right(), e.left);
}

} // namespace ddt
