// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "core/guide/contour.h"
#include "core/lattice/crossed_columns.h"
#include "core/lattice/divisions.h"

namespace ddt {

namespace {

Site edge_site(Vec v, Vec left, Vec right) {
    Site s;
    s.edge = Edge{v, left, right, 0, 0};
    return s;
}

// The edges of the starting mesh by how the cells beside them are divided: 1 down, 0 up.

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

/// Whether a cell's diagonal goes down: the one along its contour, or `without` if there is none.
uint8_t down_along(uint32_t word, uint8_t without) {
    const int xy = contour_xy(word);
    return xy == 0 ? without : xy < 0;
}

} // namespace

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
    const auto row = [&](int y) { return guide + size_t(y) * size_t(width); };
    // An upright edge between two cells and the diagonal after it, which are stored at once.
    using Sites = std::array<Site, 2>;
    const Sites uprights[4] = {{vertical(0, 0, true, true), diagonal(0)},
                               {vertical(0, 1, true, true), diagonal(1)},
                               {vertical(1, 0, true, true), diagonal(0)},
                               {vertical(1, 1, true, true), diagonal(1)}};

    // down(x, y): the cell's diagonal goes from upper left to lower right. Kept for two rows of
    // cells, since a horizontal edge has its apexes in both.
    const int last = width - 1;
    std::optional<ContourRows> words;
    if (contours)
        words.emplace(guide, width, height);
    std::vector<uint8_t> above(size_t(width), 0), below(size_t(width), 0);
    for (int y = 0; y < height; ++y) {
        const float* z = row(y);
        const bool has_above = y > 0, has_below = y + 1 < height;
        if (has_below) {
            const float* under = row(y + 1);
            for (int x = 0; x < last; ++x)
                below[size_t(x)] =
                    !flat | (std::fabs(z[x] - under[x + 1]) <= std::fabs(z[x + 1] - under[x]));
        }
        const uint32_t* word = has_below && contours ? words->next() : nullptr;
        for (int x = 0; word && flat && x < last; ++x)
            below[size_t(x)] = down_along(word[x], below[size_t(x)]);
        const Site levels[4] = {
            horizontal(0, 0, has_above, has_below), horizontal(0, 1, has_above, has_below),
            horizontal(1, 0, has_above, has_below), horizontal(1, 1, has_above, has_below)};
        Site* even = m_sites.data() + site(0, 2 * y);
        for (int x = 0; x < last; ++x) {
            even[2 * x].vertex = Vertex{z[x], {word ? word[x] : 0}};
            even[2 * x + 1] = levels[2 * above[size_t(x)] + below[size_t(x)]];
        }
        even[2 * last].vertex = Vertex{z[last], {0}};
        if (!has_below)
            break;
        Site* odd = m_sites.data() + site(0, 2 * y + 1);
        odd[0] = vertical(0, below[0], false, true);
        odd[1] = diagonal(below[0]);
        for (int x = 1; x < last; ++x)
            std::copy_n(uprights[2 * below[size_t(x) - 1] + below[size_t(x)]].data(), 2,
                        odd + 2 * x);
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
    const Vec c = e.left, d = e.right;
    // Side ac loses apex b and gets d; cb: a -> d; bd: a -> c; da: b -> c.
    const Vec came[4] = {d, d, c, c};
    for (int k = 0; k < 4; ++k) {
        Edge& side = edge(m + offset(q.middle[k]));
        (side.left == q.inner[k] ? side.left : side.right) = came[k] - q.middle[k];
    }
    e.left = -e.v;
    e.right = e.v;
    e.v = c;
    const int down = std::abs(int(c.y));
    m_longest = std::max({m_longest, std::abs(int(c.x)), down});
    if (down > 1) // start() knows of one row
        note_down(m, down);
}

void Lattice::flip_back(int m) {
    flip(m);
    // Flipped twice it runs the other way.
    Edge& e = edge(m);
    e.v = -e.v;
    std::swap(e.left, e.right);
}

} // namespace ddt
