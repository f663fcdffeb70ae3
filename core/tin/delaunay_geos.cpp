// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <new>

#include <geos_c.h>

#include "core/tin/delaunay.h"
#include "ddt/points.h"

namespace ddt {

namespace {

/// Frees what GEOS made.
class Geos {
public:
    Geos() : m_handle(GEOS_init_r()) {
        GEOSContext_setErrorMessageHandler_r(
            m_handle,
            [](const char* message, void* text) { *static_cast<std::string*>(text) = message; },
            &m_message);
    }
    ~Geos() { GEOS_finish_r(m_handle); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    GEOSContextHandle_t handle() const { return m_handle; }
    const std::string& message() const { return m_message; }

    struct Destroy {
        GEOSContextHandle_t handle;
        void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;
    Geometry own(GEOSGeometry* g) const { return Geometry(g, Destroy{m_handle}); }

private:
    std::string m_message;
    GEOSContextHandle_t m_handle;
};

/// The points as a line, which is only a way to hand them over.
Geos::Geometry line_of(const Geos& geos, const std::vector<Steps>& points) {
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos.handle(), unsigned(points.size()), 2);
    if (!sequence)
        return geos.own(nullptr);
    for (size_t i = 0; i < points.size(); ++i)
        GEOSCoordSeq_setXY_r(geos.handle(), sequence, unsigned(i), points[i].x, points[i].y);
    return geos.own(GEOSGeom_createLineString_r(geos.handle(), sequence));
}

/// The index of the point at (x, y), which is one of them.
int32_t index_of(const std::vector<Steps>& points, double x, double y) {
    const auto found =
        std::lower_bound(points.begin(), points.end(), Steps{int32_t(x), int32_t(y)}, before);
    return int32_t(found - points.begin());
}

} // namespace

bool has_delaunay() {
    return true;
}

bool find_delaunay(const std::vector<Steps>& points, std::vector<std::array<int32_t, 3>>& triangles,
                   std::string& error) {
    const Geos geos;
    const GEOSContextHandle_t handle = geos.handle();
    const Geos::Geometry line = line_of(geos, points);
    const Geos::Geometry collection =
        geos.own(line ? GEOSDelaunayTriangulation_r(handle, line.get(), 0, 0) : nullptr);
    if (!collection) {
        // What GEOS caught is known by its text alone.
        if (geos.message().find("bad_alloc") != std::string::npos)
            throw std::bad_alloc();
        error = "ddt: GEOS cannot triangulate the points: " + geos.message();
        return false;
    }
    const int count = GEOSGetNumGeometries_r(handle, collection.get());
    triangles.clear();
    triangles.reserve(size_t(count));
    for (int i = 0; i < count; ++i) {
        const GEOSGeometry* ring =
            GEOSGetExteriorRing_r(handle, GEOSGetGeometryN_r(handle, collection.get(), i));
        const GEOSCoordSequence* corners = GEOSGeom_getCoordSeq_r(handle, ring);
        std::array<int32_t, 3> t;
        for (unsigned k = 0; k < 3; ++k) {
            double x = 0, y = 0;
            GEOSCoordSeq_getXY_r(handle, corners, k, &x, &y);
            t[k] = index_of(points, x, y);
        }
        const int64_t area =
            orientation(points[size_t(t[0])], points[size_t(t[1])], points[size_t(t[2])]);
        if (area < 0)
            std::swap(t[1], t[2]);
        if (area != 0)
            triangles.push_back(t);
    }
    return true;
}

} // namespace ddt
