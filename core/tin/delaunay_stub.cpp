// SPDX-License-Identifier: Apache-2.0
// In place of delaunay_geos.cpp where GEOS is not there.
#include "core/tin/delaunay.h"
#include "ddt/points.h"

namespace ddt {

bool has_delaunay() {
    return false;
}

bool find_delaunay(const std::vector<Steps>&, std::vector<std::array<int32_t, 3>>&,
                   std::string& error) {
    error = "ddt: built without GEOS, which triangulates points; give a mesh with triangles";
    return false;
}

} // namespace ddt
