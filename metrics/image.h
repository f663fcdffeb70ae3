// SPDX-License-Identifier: Apache-2.0
// What metrics compare: values in the units of the display, 0 black to 255 white. Two planes or
// images that are compared with one another have one width and one height (but of overshoot()),
// which whoever compares them has to see to.
#pragma once

#include <cstddef>
#include <vector>

namespace metrics {

/// One number a pixel, row by row.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;

    Plane() = default;
    Plane(int w, int h, double value = 0)
        : width(w), height(h), values(size_t(w) * size_t(h), value) {}
    double& at(int x, int y) { return values[size_t(y) * size_t(width) + size_t(x)]; }
    double at(int x, int y) const { return values[size_t(y) * size_t(width) + size_t(x)]; }
    bool empty() const { return values.empty(); }
};

/// Red, green, blue.
struct Image {
    Plane channels[3];
    int width() const { return channels[0].width; }
    int height() const { return channels[0].height; }
};

/// Luma of ITU-R BT.601: 0.299 R + 0.587 G + 0.114 B.
Plane luma(const Image& image);

/// The part that is left when `border` pixels are cut off on each side.
Plane without_border(const Plane& plane, int border);
Image without_border(const Image& image, int border);

/// Means of 2x2 pixels; an odd last row or column is dropped.
Plane halved(const Plane& plane);

} // namespace metrics
