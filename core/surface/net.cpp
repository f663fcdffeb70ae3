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

/// `count` floats of each of n pixels that are `channels` floats apart, `step` floats apart in
/// `to`.
template <int count>
void copy_pixels(const float* from, size_t channels, size_t n, float* to, int step) {
    for (size_t i = 0; i < n; ++i, from += channels, to += step)
        for (int c = 0; c < group_size; ++c)
            to[c] = c < count ? from[c] : 0.0f;
}

/// n pixels of a group, from pixel `first` on.
void copy_pixels(const GroupValues& values, size_t first, size_t n, float* to, int step) {
    const auto channels = size_t(values.channels);
    const float* from = values.values + first * channels + size_t(values.first);
    static_assert(group_size == 4, "the cases");
    switch (values.count) {
    case 1:
        return copy_pixels<1>(from, channels, n, to, step);
    case 2:
        return copy_pixels<2>(from, channels, n, to, step);
    case 3:
        return copy_pixels<3>(from, channels, n, to, step);
    default:
        return copy_pixels<4>(from, channels, n, to, step);
    }
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

void set_vertices(const Lattice& lattice, ValueRows& values, const Rect& part, Net& net) {
    for (int y = part.y0; y < part.y1; ++y)
        copy_pixels<group_size>(values.row(y) + ptrdiff_t(part.x0) * group_size, group_size,
                                size_t(part.width()), net.at(lattice.vertex_site(part.x0, y)),
                                2 * group_size);
}

} // namespace ddt
