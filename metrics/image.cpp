// SPDX-License-Identifier: Apache-2.0
#include "metrics/image.h"

namespace metrics {

Plane luma(const Image& image) {
    Plane out(image.width(), image.height());
    for (size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = 0.299 * image.channels[0].values[i] + 0.587 * image.channels[1].values[i] +
                        0.114 * image.channels[2].values[i];
    return out;
}

Plane without_border(const Plane& plane, int border) {
    if (plane.width <= 2 * border || plane.height <= 2 * border)
        return {};
    Plane out(plane.width - 2 * border, plane.height - 2 * border);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.at(x, y) = plane.at(x + border, y + border);
    return out;
}

Image without_border(const Image& image, int border) {
    Image out;
    for (int c = 0; c < 3; ++c)
        out.channels[c] = without_border(image.channels[c], border);
    return out;
}

Plane halved(const Plane& plane) {
    Plane out(plane.width / 2, plane.height / 2);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.at(x, y) = (plane.at(2 * x, 2 * y) + plane.at(2 * x + 1, 2 * y) +
                            plane.at(2 * x, 2 * y + 1) + plane.at(2 * x + 1, 2 * y + 1)) /
                           4;
    return out;
}

} // namespace metrics
