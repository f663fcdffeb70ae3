// SPDX-License-Identifier: Apache-2.0
// Where a walk round a vertex begins: Lattice::find_first_edges() and its kin.
#include <algorithm>
#include <array>
#include <vector>

#include "core/base/vectors/compress_lanes.h"
#include "core/base/vectors/gathers.h"
#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"
#include "core/lattice/crossed_columns.h"
#include "core/lattice/lattice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/first_edges.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

#ifndef DDT_FIRST_EDGES_ONCE
#define DDT_FIRST_EDGES_ONCE
namespace ddt {
/// A vertex' neighbours, in the order of the addresses of the edges to them.
constexpr std::array<std::array<int, 2>, 8> neighbours{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
} // namespace ddt
#endif

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;

#include "core/base/vectors/compress-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/site_lanes-inl.h"

/// Twin of first_short_edge() for n vertices that are not on the rim; of each two bytes, and as
/// many as fill vectors.
HWY_ATTR void first_short_edges(const Lattice& lattice, const int* vertices, size_t n, int* first) {
    const DI di;
    const SiteLanes mesh(lattice);
    for (size_t i = 0; i < n; i += hn::Lanes(di)) {
        const Ints vertex = load_sites(vertices + i, n - i);
        VecLanes found{hn::Zero(di)};
        // Backwards: the first is chosen last.
        for (size_t k = neighbours.size(); k-- > 0;) {
            const int x = neighbours[k][0], y = neighbours[k][1];
            const VecLanes to{hn::Set(di, y * 65536 + (x & 0xffff))};
            const Ints there = vertex + Ints{hn::Set(di, lattice.offset(Vec(x, y)))};
            const VI v = mesh.flippable_edge(there).v.xy;
            const auto is_it = hn::Or(hn::Eq(v, to.xy), hn::Eq(v, VecLanes(-to).xy));
            found.xy = hn::IfThenElse(is_it, to.xy, found.xy);
        }
        hn::StoreU(found.bytes(), di, first + i);
    }
}

/// Those of n edges that are longer than a diagonal, and their v, as two bytes each. Returns how
/// many; whole vectors are written.
HWY_ATTR size_t long_edges(const Lattice& lattice, const int* edges, size_t n, int* sites,
                           int* vectors) {
    const DI di;
    const SiteLanes mesh(lattice);
    size_t found = 0;
    for (size_t i = 0; i < n; i += hn::Lanes(di)) {
        const Ints m = load_sites(edges + i, n - i);
        const VecLanes v = mesh.flippable_edge(m).v;
        const VI beyond_one = hn::AndNot(VecLanes::ones().xy, hn::BitCast(di, hn::Abs(v.halves())));
        const auto is_long = hn::And(hn::Gt(beyond_one, hn::Zero(di)), hn::FirstN(di, n - i));
        store_compressed(v.bytes(), is_long, vectors + found);
        found += store_compressed(m.i, is_long, sites + found);
    }
    return found;
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(first_short_edges);
HWY_EXPORT(long_edges);

namespace {

/// In the order of the addresses of edges from one vertex.
int rank(Vec to) {
    return 256 * to.y + to.x;
}

/// The first of the edges from pixel (x, y) to its neighbours; zero: none.
Vec first_short_edge(const Lattice& lattice, int x, int y) {
    const int vertex = lattice.vertex_site(x, y);
    for (const auto& to : neighbours) {
        if (unsigned(x + to[0]) >= unsigned(lattice.width()) ||
            unsigned(y + to[1]) >= unsigned(lattice.height()))
            continue;
        const Vec v(to[0], to[1]), there = lattice.edge(vertex + lattice.offset(v)).v;
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
    if (m_width > widest_lanes)
        return find_first_edges(part);
    find_short_first_edges(part);
    find_long_first_edges(part);
}

/// Fill Vertex::first as if no edge were longer than a diagonal; zero where all are.
void Lattice::find_short_first_edges(const Rect& part) {
    const auto find_at_rim = [&](int x, int y) {
        vertex(vertex_site(x, y)).first = first_short_edge(*this, x, y);
    };
    const int last = m_width - 1, begin = std::max(part.x0, 1), end = std::min(part.x1, last);
    std::vector<int> vertices(size_t(m_width) + cells_at_once), first(vertices.size() + most_lanes);
    for (int y = part.y0; y < part.y1; ++y) {
        if (part.x0 == 0)
            find_at_rim(0, y);
        if (part.x1 > last)
            find_at_rim(last, y);
        if (y == 0 || y == m_height - 1) {
            for (int x = begin; x < end; ++x)
                find_at_rim(x, y);
            continue;
        }
        const NearDivisions near(*this, y);
        const int n = list_crossed(
            begin, end, [&](int x) { return near.crossed_beside(x); }, vertices.data());
        for (int i = 0; i < n; ++i)
            vertices[size_t(i)] = vertex_site(vertices[size_t(i)], y);
        HWY_DYNAMIC_DISPATCH(first_short_edges)(*this, vertices.data(), size_t(n), first.data());
        for (int i = 0; i < n; ++i)
            vertex(vertices[size_t(i)]).first = vec_of(uint32_t(first[size_t(i)]));
    }
}

/// Look at longer edges, whose midpoints are in the cells that they cross, or between two of them.
void Lattice::find_long_first_edges(const Rect& part) {
    // Branch-free: the branch would be mispredicted.
    const auto add = [&](int end, Vec to) {
        Vec& first = vertex(end).first;
        const bool comes_first = (rank(to) < rank(first)) | first.zero();
        first = comes_first ? to : first;
    };
    // How far, in cells, midpoints are from the part at most; beyond the cells round the part it is
    // not known which are crossed.
    const int far = m_longest / 2 + 1;
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1, m_width - 1);
    const int x0 = std::max(part.x0 - far, 0), x1 = std::min(part.x1 + far, m_width - 1),
              y1 = std::min(part.y1 + far, m_height - 1);
    const size_t cells = size_t(m_width) + cells_at_once;
    std::vector<int> columns(cells), edges(3 * cells), sites(3 * cells + most_lanes),
        vectors(sites.size());
    for (int y = std::max(part.y0 - far, 0); y < y1; ++y) {
        size_t n = 0;
        const auto look_at = [&](int x) {
            const int upper_left = vertex_site(x, y);
            edges[n++] = upper_left + 1;
            edges[n++] = upper_left + m_stride;
            edges[n++] = upper_left + m_stride + 1;
        };
        const bool known = part.y0 - 1 <= y && y < part.y1;
        const Division* row = divisions(y);
        const int first = known ? begin : x1, last = known ? end : x1;
        for (int x = x0; x < first; ++x)
            look_at(x);
        const int crossed = list_crossed(
            first, last, [&](int x) { return crossed_cells(row + x); }, columns.data());
        for (int i = 0; i < crossed; ++i)
            look_at(columns[size_t(i)]);
        for (int x = last; x < x1; ++x)
            look_at(x);
        const size_t found =
            HWY_DYNAMIC_DISPATCH(long_edges)(*this, edges.data(), n, sites.data(), vectors.data());
        for (size_t i = 0; i < found; ++i) {
            const Vec v = vec_of(uint32_t(vectors[i]));
            add(sites[i] - offset(v), v);
            add(sites[i] + offset(v), -v);
        }
    }
}

} // namespace ddt
#endif
