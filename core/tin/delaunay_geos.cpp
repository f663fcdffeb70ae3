// SPDX-License-Identifier: Apache-2.0
// With DDT_GEOS_BY_NAME, for modules that take nothing of the system's along, the library is opened
// by name where it is first needed, and never closed.
#include <algorithm>
#include <memory>
#include <new>

#include <geos_c.h>
#ifdef DDT_GEOS_BY_NAME
#include <dlfcn.h>
#endif

#include "core/tin/delaunay.h"
#include "ddt/points.h"

namespace ddt {

namespace {

#define DDT_GEOS_FUNCTIONS(F)                                                                      \
    F(GEOS_init_r)                                                                                 \
    F(GEOS_finish_r)                                                                               \
    F(GEOSContext_setErrorMessageHandler_r)                                                        \
    F(GEOSGeom_destroy_r)                                                                          \
    F(GEOSCoordSeq_create_r)                                                                       \
    F(GEOSCoordSeq_setXY_r)                                                                        \
    F(GEOSCoordSeq_getXY_r)                                                                        \
    F(GEOSGeom_createLineString_r)                                                                 \
    F(GEOSDelaunayTriangulation_r)                                                                 \
    F(GEOSGetNumGeometries_r)                                                                      \
    F(GEOSGetGeometryN_r)                                                                          \
    F(GEOSGetExteriorRing_r)                                                                       \
    F(GEOSGeom_getCoordSeq_r)

/// The library's functions.
struct Api {
#define DDT_GEOS_MEMBER(name) decltype(&::name) name = nullptr;
    DDT_GEOS_FUNCTIONS(DDT_GEOS_MEMBER)
#undef DDT_GEOS_MEMBER

    /// False if one of them cannot be had.
    bool load() {
#ifdef DDT_GEOS_BY_NAME
        void* library = dlopen("libgeos_c.so.1", RTLD_NOW | RTLD_LOCAL);
        const auto find = [&](const char* name, auto& f) {
            f = library
                    ? reinterpret_cast<std::remove_reference_t<decltype(f)>>(dlsym(library, name))
                    : nullptr;
            return f != nullptr;
        };
#define DDT_GEOS_FIND(name) &&find(#name, name)
        return true DDT_GEOS_FUNCTIONS(DDT_GEOS_FIND);
#undef DDT_GEOS_FIND
#else
#define DDT_GEOS_TAKE(name) name = &::name;
        DDT_GEOS_FUNCTIONS(DDT_GEOS_TAKE)
#undef DDT_GEOS_TAKE
        return true;
#endif
    }
};

/// Null where there is no library.
const Api* api() {
    static Api functions;
    static const bool loaded = functions.load();
    return loaded ? &functions : nullptr;
}

/// Frees what GEOS made.
class Geos {
public:
    Geos() : m_handle(api()->GEOS_init_r()) {
        api()->GEOSContext_setErrorMessageHandler_r(
            m_handle,
            [](const char* message, void* text) { *static_cast<std::string*>(text) = message; },
            &m_message);
    }
    ~Geos() { api()->GEOS_finish_r(m_handle); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    GEOSContextHandle_t handle() const { return m_handle; }
    const std::string& message() const { return m_message; }

    struct Destroy {
        GEOSContextHandle_t handle;
        void operator()(GEOSGeometry* g) const { api()->GEOSGeom_destroy_r(handle, g); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;
    Geometry own(GEOSGeometry* g) const { return Geometry(g, Destroy{m_handle}); }

private:
    std::string m_message;
    GEOSContextHandle_t m_handle;
};

/// The points as a line, which is only a way to hand them over.
Geos::Geometry line_of(const Geos& geos, const std::vector<Steps>& points) {
    GEOSCoordSequence* sequence =
        api()->GEOSCoordSeq_create_r(geos.handle(), unsigned(points.size()), 2);
    if (!sequence)
        return geos.own(nullptr);
    for (size_t i = 0; i < points.size(); ++i)
        api()->GEOSCoordSeq_setXY_r(geos.handle(), sequence, unsigned(i), points[i].x, points[i].y);
    return geos.own(api()->GEOSGeom_createLineString_r(geos.handle(), sequence));
}

/// The index of the point at (x, y), which is one of them.
int32_t index_of(const std::vector<Steps>& points, double x, double y) {
    const auto found =
        std::lower_bound(points.begin(), points.end(), Steps{int32_t(x), int32_t(y)}, before);
    return int32_t(found - points.begin());
}

} // namespace

bool has_delaunay() {
    return api() != nullptr;
}

bool find_delaunay(const std::vector<Steps>& points, std::vector<std::array<int32_t, 3>>& triangles,
                   std::string& error) {
    if (!api()) {
        error = "ddt: triangulating points needs GEOS, whose libgeos_c.so.1 cannot be loaded";
        return false;
    }
    const Geos geos;
    const GEOSContextHandle_t handle = geos.handle();
    const Geos::Geometry line = line_of(geos, points);
    const Geos::Geometry collection =
        geos.own(line ? api()->GEOSDelaunayTriangulation_r(handle, line.get(), 0, 0) : nullptr);
    if (!collection) {
        // What GEOS caught is known by its text alone.
        if (geos.message().find("bad_alloc") != std::string::npos)
            throw std::bad_alloc();
        error = "ddt: GEOS cannot triangulate the points: " + geos.message();
        return false;
    }
    const int count = api()->GEOSGetNumGeometries_r(handle, collection.get());
    triangles.clear();
    triangles.reserve(size_t(count));
    for (int i = 0; i < count; ++i) {
        const GEOSGeometry* ring = api()->GEOSGetExteriorRing_r(
            handle, api()->GEOSGetGeometryN_r(handle, collection.get(), i));
        const GEOSCoordSequence* corners = api()->GEOSGeom_getCoordSeq_r(handle, ring);
        std::array<int32_t, 3> t;
        for (unsigned k = 0; k < 3; ++k) {
            double x = 0, y = 0;
            api()->GEOSCoordSeq_getXY_r(handle, corners, k, &x, &y);
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
