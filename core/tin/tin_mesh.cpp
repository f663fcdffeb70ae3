// SPDX-License-Identifier: Apache-2.0
#include "core/tin/tin_mesh.h"

#include <utility>

#include "core/base/float_mode.h"
#include "core/triangulate/run_scheme.h"

namespace ddt {

TinMesh::TinMesh(Tin& tin, Cost cost)
    : m_tin(tin), m_cost(cost), m_faces(tin.triangles.size()), m_gains(tin.edges.size(), no_gain) {
    for (size_t t = 0; t < m_faces.size(); ++t)
        find_face(int32_t(t));
}

void TinMesh::find_face(int32_t triangle) {
    const Tin::Triangle& t = m_tin.triangles[size_t(triangle)];
    const Tin::Vertex &p = m_tin.vertices[size_t(t.vertex[0])],
                      &q = m_tin.vertices[size_t(t.vertex[1])],
                      &r = m_tin.vertices[size_t(t.vertex[2])];
    dispatch(m_cost, [&](auto which) {
        m_faces[size_t(triangle)] =
            scalar::face_of<decltype(which)>(p, q, r, orientation(p.at, q.at, r.at), m_tin.pixel);
    });
}

uint64_t TinMesh::place(int m, int origin_x, int origin_y) const {
    if (m_places.empty())
        m_places = places_of(m_tin, origin_x, origin_y);
    return m_places[size_t(m)];
}

std::vector<uint64_t> places_of(const Tin& tin, int origin_x, int origin_y) {
    std::vector<uint64_t> places;
    places.reserve(tin.edges.size());
    for (size_t i = 0; i < tin.edges.size(); ++i) {
        const auto ends = tin.ends(int(i));
        const Steps a = tin.vertices[size_t(ends[0])].at, b = tin.vertices[size_t(ends[1])].at;
        // Up to 2^31 before the origins.
        const uint32_t y = uint32_t(a.y) + uint32_t(b.y) + 2 * uint32_t(origin_y);
        const uint32_t x = uint32_t(a.x) + uint32_t(b.x) + 2 * uint32_t(origin_x);
        places.push_back(uint64_t(y) << 32 | x);
    }
    return places;
}

void TinMesh::flip(int m) {
    ddt::flip(m_tin, m);
    const Tin::Edge e = m_tin.edges[size_t(m)];
    find_face(e.left);
    find_face(e.right);
}

void TinMesh::flip_back(int m) {
    flip(m);
    // Flipped twice it runs the other way.
    Tin::Edge& e = m_tin.edges[size_t(m)];
    std::swap(e.left, e.right);
}

double total_cost(const TinMesh& mesh) {
    const Tin& tin = mesh.tin();
    return dispatch(mesh.cost(), [&](auto which) {
        double sum = 0;
        for (size_t m = 0; m < tin.edges.size(); ++m) {
            const Tin::Edge e = tin.edges[m];
            if (e.left < 0 || e.right < 0)
                continue;
            const auto ends = tin.ends(int(m));
            sum += double(scalar::between<decltype(which)>(
                mesh.face(e.left), mesh.face(e.right), tin.vertices[size_t(ends[0])].at,
                tin.vertices[size_t(ends[1])].at, tin.pixel));
        }
        return sum;
    });
}

void triangulate(Tin& tin, const MeshOptions& options, Workspace& workspace,
                 Statistics& statistics) {
    const DenormalsAreZero as_on_gpus;
    TinMesh mesh(tin, options.cost);
    run_scheme(mesh, options, workspace, statistics);
}

} // namespace ddt
