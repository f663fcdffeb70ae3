// SPDX-License-Identifier: Apache-2.0
// What meshes of scattered points are good for, in figures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ddt/points.h"
#include "tests/core/random.h"

namespace ddt::bench {

/// A way to flip edges; `pixel` none, so the Delaunay triangulation.
struct Way {
    std::string name;
    MeshOptions options;
};
/// Delaunay, then every cost by `scheme`.
std::vector<Way> ways_of(const std::string& scheme);

/// A random number from 0 to below 1, of as many bits as a double has.
inline double share_of(test::Random& random) {
    return double(random.bits() >> 11) / double(uint64_t(1) << 53);
}

/// RMS and largest error of the test functions from 33, 100 and 1000 points.
bool print_functions(const std::vector<Way>& ways, int sets);
/// A picture from `share` of its pixels.
bool print_pictures(const std::vector<Way>& ways, const std::vector<std::string>& files, int crop,
                    double share);
/// Holes: single pixels and blocks, beside OpenImageIO's fillholes_pushpull.
bool print_fill(const std::vector<Way>& ways, const std::vector<std::string>& files, int crop);
/// Seconds of one core to triangulate and to flip.
bool print_time(const std::string& scheme, const std::vector<int>& counts);

} // namespace ddt::bench
