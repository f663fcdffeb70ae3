// SPDX-License-Identifier: Apache-2.0
#include "core/surface/net.h"

#include <cstring>

namespace ddt {

void set_vertices(const Lattice& lattice, const float* values, int channels, int first, int count,
                  Net& net) {
    net.values.resize(lattice.size() * group_size);
    net.stride = lattice.stride();
    net.first = 0;
    set_vertices(lattice, {values, channels, first, count},
                 {0, 0, lattice.width(), lattice.height()}, net);
}

void set_vertices(const Lattice& lattice, const GroupValues& values, const Rect& part, Net& net) {
    const auto width = size_t(lattice.width()), channels = size_t(values.channels);
    for (int y = part.y0; y < part.y1; ++y) {
        float* z = net.at(lattice.vertex_site(part.x0, y));
        const float* from =
            values.values + (size_t(y) * width + size_t(part.x0)) * channels + values.first;
        for (int x = part.x0; x < part.x1; ++x, from += channels, z += 2 * group_size)
            for (int c = 0; c < group_size; ++c)
                z[c] = c < values.count ? from[c] : 0.0f;
    }
}

void get_vertices(const Lattice& lattice, const Net& net, int channels, int first, int count,
                  float* values) {
    for (int y = 0; y < lattice.height(); ++y) {
        const float* z = net.at(lattice.vertex_site(0, y));
        for (int x = 0; x < lattice.width(); ++x, values += channels, z += 2 * group_size)
            std::memcpy(values + first, z, size_t(count) * sizeof(float));
    }
}

} // namespace ddt
