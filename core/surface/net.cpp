// SPDX-License-Identifier: Apache-2.0
#include "core/surface/net.h"

namespace ddt {

void set_vertices(const Lattice& lattice, const float* values, int channels, int first, int count,
                  Net& net) {
    net.values.resize(lattice.size() * group_size);
    net.stride = lattice.stride();
    for (int y = 0; y < lattice.height(); ++y) {
        float* z = net.at(lattice.vertex_site(0, y));
        for (int x = 0; x < lattice.width(); ++x, values += channels, z += 2 * group_size)
            for (int c = 0; c < group_size; ++c)
                z[c] = c < count ? values[first + c] : 0.0f;
    }
}

} // namespace ddt
