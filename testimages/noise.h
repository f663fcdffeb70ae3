// SPDX-License-Identifier: Apache-2.0
// Value noise that is the same on every machine: integer hashes, smoothly interpolated.
#pragma once

#include <cmath>
#include <cstdint>

namespace testimages {

/// 0 to 1 at a lattice point.
inline double hash01(int x, int y, uint32_t seed) {
    uint32_t h = uint32_t(x) * 0x8da6b343u + uint32_t(y) * 0xd8163841u + seed * 0xcb1ab31fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return h / 4294967295.0;
}

/// 0 to 1, features about one unit large.
inline double noise(double x, double y, uint32_t seed) {
    double fx = std::floor(x), fy = std::floor(y);
    int ix = int(fx), iy = int(fy);
    double u = x - fx, v = y - fy;
    u = u * u * (3 - 2 * u);
    v = v * v * (3 - 2 * v);
    double top = hash01(ix, iy, seed) * (1 - u) + hash01(ix + 1, iy, seed) * u;
    double bottom = hash01(ix, iy + 1, seed) * (1 - u) + hash01(ix + 1, iy + 1, seed) * u;
    return top * (1 - v) + bottom * v;
}

/// 0 to 1: noise over several octaves, each half as strong and twice as fine.
inline double cloud(double x, double y, uint32_t seed, int octaves) {
    double sum = 0, weight = 0.5, total = 0;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * noise(x, y, seed + uint32_t(i));
        total += weight;
        x *= 2;
        y *= 2;
        weight *= 0.5;
    }
    return sum / total;
}

} // namespace testimages
