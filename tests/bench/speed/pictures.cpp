// SPDX-License-Identifier: Apache-2.0
#include "pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <OpenImageIO/imagebufalgo.h>

#include "noise.h"

namespace speed {

namespace {

OIIO::ImageBuf clouds() {
    using testimages::cloud;
    constexpr int side = 1024;
    OIIO::ImageBuf image(OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::FLOAT));
    for (OIIO::ImageBuf::Iterator<float> it(image); !it.done(); ++it) {
        const double x = it.x(), y = it.y();
        // Grain and leaves down to the single pixel, as busy a mesh as a photograph's.
        const double grain = cloud(x / 5, y / 4, 7, 3), shade = cloud(x / 300, y / 300, 20, 3);
        const double texture = 0.5 * cloud(x / 90, y / 90, 1, 7) + 0.5 * grain;
        const bool front = cloud(x / 120, y / 120, 40, 5) > 0.55,
                   thing = cloud(x / 50, y / 60, 60, 2) > 0.7;
        for (int c = 0; c < 3; ++c) {
            const double tint = 0.6 + 0.4 * testimages::hash01(c, front + 2 * thing, 80);
            it[c] = float(tint * (front ? texture * texture : 0.3 + 0.4 * shade + 0.05 * grain) +
                          0.2 * thing);
        }
    }
    return image;
}

} // namespace

const char* name_of(Format format) {
    return format == Format::linear_float ? "linear float" : "8-bit sRGB";
}

Pictures::Pictures(const std::string& path) {
    if (path.empty()) {
        m_subject = clouds();
        return;
    }
    OIIO::ImageBuf file(path);
    if (!file.read(0, 0, true)) {
        std::fprintf(stderr, "%s\n", file.geterror().c_str());
        std::exit(1);
    }
    m_subject = file.nchannels() == 3
                    ? file
                    : OIIO::ImageBufAlgo::channels(file, 3,
                                                   {0, std::min(1, file.nchannels() - 1),
                                                    std::min(2, file.nchannels() - 1)});
}

OIIO::ImageBuf Pictures::make(double megapixels, Format format) const {
    const int side = int(std::lround(std::sqrt(megapixels * 1e6)));
    const bool codes = format == Format::srgb_8bit;
    OIIO::ImageBuf image(
        OIIO::ImageSpec(side, side, 3, codes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT));
    const OIIO::ImageSpec& subject = m_subject.spec();
    for (int y = 0; y < side; y += subject.height)
        for (int x = 0; x < side; x += subject.width)
            OIIO::ImageBufAlgo::paste(image, x, y, 0, 0, m_subject);
    image.specmod().attribute("oiio:ColorSpace", codes ? "sRGB" : "Linear");
    return image;
}

} // namespace speed
