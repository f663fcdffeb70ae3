#include "core/lattice/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ddt {

namespace {

Site edge_site(Vec v, Vec left, Vec right) {
    Site s;
    s.edge = Edge{v, left, right, 0, 0};
    return s;
}

} // namespace

void Lattice::start(int width, int height, const float* guide, bool flat) {
    m_width = width;
    m_height = height;
    m_stride = 2 * width;
    m_fresh = true;
    m_longest = 1;
    m_sites.resize(size_t(m_stride) * size_t(2 * height - 1));
    auto z = [&](int x, int y) { return guide[size_t(y) * size_t(width) + size_t(x)]; };

    // down(x, y): the cell's diagonal goes from upper left to lower right. Kept for two rows of
    // cells, since a horizontal edge has its apexes in both.
    std::vector<uint8_t> above(size_t(width), 0), below(size_t(width), 0);
    for (int y = 0; y < height; ++y) {
        const bool has_below = y + 1 < height;
        if (has_below)
            for (int x = 0; x + 1 < width; ++x)
                below[size_t(x)] = !flat || std::fabs(z(x, y) - z(x + 1, y + 1)) <=
                                                std::fabs(z(x + 1, y) - z(x, y + 1));
        Site* even = m_sites.data() + site(0, 2 * y);
        for (int x = 0; x < width; ++x) {
            even[2 * x].vertex = Vertex{z(x, y), Vec(), 0};
            if (x + 1 == width)
                break;
            // Horizontal edge, v = (1, 0): left (det > 0) is below.
            even[2 * x + 1] =
                edge_site({1, 0}, has_below ? Vec(below[size_t(x)] ? 1 : -1, 2) : Vec(),
                          y > 0 ? Vec(above[size_t(x)] ? -1 : 1, -2) : Vec());
        }
        if (!has_below)
            break;
        Site* odd = m_sites.data() + site(0, 2 * y + 1);
        for (int x = 0; x < width; ++x) {
            // Vertical edge, v = (0, 1): left is towards smaller x.
            odd[2 * x] = edge_site({0, 1}, x > 0 ? Vec(-2, below[size_t(x) - 1] ? -1 : 1) : Vec(),
                                   x + 1 < width ? Vec(2, below[size_t(x)] ? 1 : -1) : Vec());
            if (x + 1 == width)
                break;
            odd[2 * x + 1] = below[size_t(x)] ? edge_site({1, 1}, {-1, 1}, {1, -1})
                                              : edge_site({-1, 1}, {-1, -1}, {1, 1});
        }
        above.swap(below);
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
    m_longest = std::max({m_longest, std::abs(int(c.x)), std::abs(int(c.y))});
}

void Lattice::find_first_edges() {
    // Backwards: the smallest address is written last.
    for (int y = 2 * m_height - 2; y >= 0; --y) {
        const int odd = y & 1;
        for (int x = 2 * m_width - 2 - (1 - odd), step = 2 - odd; x >= 0; x -= step) {
            const int m = site(x, y);
            const Vec v = edge(m).v;
            const int to_b = offset(v);
            vertex(m - to_b).first = v;
            vertex(m + to_b).first = -v;
        }
    }
}

} // namespace ddt
