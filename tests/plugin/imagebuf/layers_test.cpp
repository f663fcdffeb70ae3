// SPDX-License-Identifier: Apache-2.0
// Images of several layers: whose edges the mesh follows.
#include <cmath>

#include "tests/plugin/images.h"

namespace {

using images::enlarged;
using images::make;
using images::value;

constexpr int small = 40, times = 4;

/// An image of channels of these names, each f(x, y, channel); alpha and depth as OpenImageIO's
/// reader of EXR has them.
OIIO::ImageBuf make_layers(const std::vector<std::string>& names, int alpha, int depth,
                           const std::function<float(int, int, int)>& f) {
    auto image = make(small, small, int(names.size()));
    image.specmod().channelnames = names;
    image.specmod().alpha_channel = alpha;
    image.specmod().z_channel = depth;
    images::fill(image, f);
    return image;
}

/// How many numbers of `count` channels from `first` on differ from those of `alone`.
int count_differing(const OIIO::ImageBuf& image, int first, const OIIO::ImageBuf& alone,
                    int count) {
    int found = 0;
    for (int y = 0; y < small * times; ++y)
        for (int x = 0; x < small * times; ++x)
            for (int c = 0; c < count; ++c)
                found += value(image, x, y, first + c) != value(alone, x, y, c);
    return found;
}

float soft_disc(int x, int y) {
    return images::disc(x, y, small);
}

TEST(Layers, ThePictureHasTheMeshThatItHasAlone) {
    const auto picture = [](int x, int y, int c) {
        return c == 3 ? 1.0f
                      : soft_disc(x, y) * (0.5f + 0.1f * float(c)) + 0.02f * float((x * y) % 7);
    };
    const auto alone = make_layers({"R", "G", "B", "A"}, 3, -1, picture);
    const auto among = make_layers(
        {"View.AO.R", "View.AO.G", "View.AO.B", "View.AO.A", "View.Combined.R", "View.Combined.G",
         "View.Combined.B", "View.Combined.A", "View.Depth.Z"},
        3, 8, [&](int x, int y, int c) {
            return c == 8 ? 10.0f : c >= 4 ? picture(x, y, c - 4) : float((x / 3 + c) % 5) / 5;
        });
    EXPECT_EQ(count_differing(enlarged(among, small * times, small * times), 4,
                              enlarged(alone, small * times, small * times), 4),
              0);
}

/// Root of the mean square by which a channel differs from the same numbers enlarged by themselves.
double noise_of_mesh(const OIIO::ImageBuf& image, int channel) {
    const auto alone =
        make_layers({"Y"}, -1, -1, [&](int x, int y, int) { return value(image, x, y, channel); });
    const auto with = enlarged(image, small * times, small * times),
               without = enlarged(alone, small * times, small * times);
    double sum = 0;
    for (int y = 0; y < small * times; ++y)
        for (int x = 0; x < small * times; ++x)
            sum += std::pow(value(with, x, y, channel) - value(without, x, y, 0), 2);
    return std::sqrt(sum) / (small * times);
}

TEST(Layers, VectorsHaveTheEdgesOfEachComponent) {
    for (const auto& names :
         {std::vector<std::string>{"X", "Y", "Z"}, {"N.X", "N.Y", "N.Z"}, {"m1", "m2", "m3"}})
        for (int edge = 0; edge < 3; ++edge) {
            const auto image =
                make_layers(names, -1, names[2].back() == 'Z' ? 2 : -1, [&](int x, int y, int c) {
                    return c == edge ? soft_disc(x, y) : 0.0f;
                });
            EXPECT_LT(noise_of_mesh(image, edge), 0.02) << names[size_t(edge)];
        }
}

TEST(Layers, MattesSideBySideHaveAnEdge) {
    const auto image = make_layers({"m1", "m2"}, -1, -1, [&](int x, int y, int c) {
        return c == 0 ? soft_disc(x, y) : 1 - soft_disc(x, y);
    });
    EXPECT_LT(noise_of_mesh(image, 0), 0.02);
}

} // namespace
