// SPDX-License-Identifier: Apache-2.0
#include "core/surface/net.h"

namespace ddt {

void set_vertices(const Lattice& lattice, const float* values, int channels, int first, int count,
                  Net& net) {
    net.values.resize(lattice.size() * group_size);
    net.stride = lattice.stride();
    net.first = 0;
    set_vertices(lattice, {values, channels, first, count},
                 {0, 0, lattice.width(), lattice.height()}, net);
}

namespace {

/// n pixels, `step` floats apart in `to`.
void copy_pixels(const GroupValues& values, size_t first, size_t n, float* to, int step) {
    const auto channels = size_t(values.channels);
    const float* from = values.values + first * channels + size_t(values.first);
    for (size_t i = 0; i < n; ++i, from += channels, to += step)
        for (int c = 0; c < group_size; ++c)
            to[c] = c < values.count ? from[c] : 0.0f;
}

} // namespace

void copy_group(const GroupValues& values, size_t pixels, float* to) {
    copy_pixels(values, 0, pixels, to, group_size);
}

void set_vertices(const Lattice& lattice, const GroupValues& values, const Rect& part, Net& net) {
    for (int y = part.y0; y < part.y1; ++y)
        copy_pixels(values, size_t(y) * size_t(lattice.width()) + size_t(part.x0),
                    size_t(part.width()), net.at(lattice.vertex_site(part.x0, y)), 2 * group_size);
}

} // namespace ddt
