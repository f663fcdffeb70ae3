// SPDX-License-Identifier: Apache-2.0
#include "core/surface/control_net.h"

#include <algorithm>
#include <cstring>

namespace ddt {

namespace {

/// `count` floats of each of n pixels that are `channels` floats apart.
template <int count>
void copy_pixels(const float* from, size_t channels, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i, from += channels, to += count)
        for (int c = 0; c < count; ++c)
            to[c] = from[c];
}

/// n pixels of a group, from pixel `first` on.
void copy_pixels(const GroupValues& values, size_t first, size_t n, float* to) {
    const auto channels = size_t(values.channels);
    const float* from = values.values + first * channels + size_t(values.first);
    if (values.count == values.channels) {
        std::copy_n(from, n * channels, to);
        return;
    }
    static_assert(group_size == 4, "the cases");
    switch (values.count) {
    case 1:
        return copy_pixels<1>(from, channels, n, to);
    case 2:
        return copy_pixels<2>(from, channels, n, to);
    case 3:
        return copy_pixels<3>(from, channels, n, to);
    default:
        return copy_pixels<4>(from, channels, n, to);
    }
}

} // namespace

const float* group_row(const GroupValues& values, int width, int y, std::vector<float>& copied) {
    const size_t first = size_t(y) * size_t(width), row = size_t(width) * size_t(values.count);
    if (values.count == values.channels)
        return values.values + size_t(y) * row;
    copied.resize(row);
    copy_pixels(values, first, size_t(width), copied.data());
    return copied.data();
}

void copy_lanes(const float* from, int pixels, int count, unsigned lanes, float* to) {
    for (int x = 0; lanes && x < pixels; ++x, from += count, to += count)
        for (int c = 0; c < count; ++c)
            if (lanes >> c & 1u)
                std::memcpy(to + c, from + c, sizeof(float)); // bits: IDs may look like NaN
}

void copy_group(const GroupValues& values, size_t pixels, float* to) {
    copy_pixels(values, 0, pixels, to);
}

void set_vertices(const Lattice& lattice, const GroupValues& values, const Rect& part,
                  ControlNet& net) {
    for (int y = part.y0; y < part.y1; ++y)
        copy_pixels(values, size_t(y) * size_t(lattice.width()) + size_t(part.x0),
                    size_t(part.width()), net.vertex(lattice.vertex_site(part.x0, y)));
}

void set_vertices(const Lattice& lattice, ValueRows& values, const Rect& part, ControlNet& net) {
    for (int y = part.y0; y < part.y1; ++y)
        std::copy_n(values.row(y) + ptrdiff_t(part.x0) * values.count(),
                    size_t(part.width()) * size_t(values.count()),
                    net.vertex(lattice.vertex_site(part.x0, y)));
}

} // namespace ddt
