// SPDX-License-Identifier: Apache-2.0
// Small images for tests, and plain ways to look at them.
#pragma once

#include <cstring>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "ddt/resize.h"

namespace images {

using OIIO::ImageBuf;
using OIIO::ImageSpec;
using OIIO::ROI;
using OIIO::TypeDesc;

inline ROI window(int x0, int x1, int y0, int y1) {
    return ROI(x0, x1, y0, y1, 0, 1);
}

/// An empty image with the given data and display windows.
inline ImageBuf make(ROI data, ROI full, int channels, TypeDesc type = OIIO::TypeFloat) {
    ImageSpec spec(data.width(), data.height(), channels, type);
    data.chbegin = full.chbegin = 0;
    data.chend = full.chend = channels;
    OIIO::set_roi(spec, data);
    OIIO::set_roi_full(spec, full);
    return ImageBuf(spec);
}

inline ImageBuf make(int width, int height, int channels, TypeDesc type = OIIO::TypeFloat) {
    return make(window(0, width, 0, height), window(0, width, 0, height), channels, type);
}

/// Set every value to f(x, y, channel).
inline void fill(ImageBuf& image, const std::function<float(int, int, int)>& f) {
    std::vector<float> pixel(size_t(image.nchannels()));
    for (int y = image.ybegin(); y < image.yend(); ++y)
        for (int x = image.xbegin(); x < image.xend(); ++x) {
            for (int c = 0; c < image.nchannels(); ++c)
                pixel[size_t(c)] = f(x, y, c);
            image.setpixel(x, y, pixel.data());
        }
}

/// Noise from `low` to `high`, the same for the same seed.
inline void noise(ImageBuf& image, float low = 0, float high = 1, unsigned seed = 1) {
    std::mt19937 random(seed);
    fill(image, [&](int, int, int) {
        return low + (high - low) * float(random() >> 8) * (1.0f / 16777216.0f);
    });
}

/// A disc with a soft shade: edges in all directions, and no noise.
inline float disc(int x, int y, int size) {
    const float u = float(x) - 0.45f * float(size), v = float(y) - 0.55f * float(size);
    const bool in = u * u + v * v < 0.1f * float(size) * float(size);
    return (in ? 0.8f : 0.1f) + 0.1f * float(x) / float(size);
}

inline float value(const ImageBuf& image, int x, int y, int c = 0) {
    return image.getchannel(x, y, 0, c);
}

/// Bytes of the pixels of `roi` (of all of them, if not defined), in the image's own type.
inline std::vector<unsigned char> bytes(const ImageBuf& image, ROI roi = {}) {
    if (!roi.defined())
        roi = image.roi();
    roi.chend = std::min(roi.chend, image.nchannels());
    const size_t value = image.spec().format.size();
    std::vector<unsigned char> all;
    for (int y = roi.ybegin; y < roi.yend; ++y)
        for (int x = roi.xbegin; x < roi.xend; ++x) {
            const auto* p = static_cast<const unsigned char*>(
                image.pixeladdr(x, y, image.spec().z, roi.chbegin));
            all.insert(all.end(), p, p + value * size_t(roi.nchannels()));
        }
    return all;
}

/// Resize by a factor into a new image; fails the test if that fails.
inline ImageBuf enlarged(const ImageBuf& src, int width, int height,
                         const ddt::Options& options = {}, int threads = 1) {
    ImageBuf dst;
    EXPECT_TRUE(ddt::resize(dst, src, options, ROI(0, width, 0, height, 0, 1), threads))
        << dst.geterror();
    return dst;
}

} // namespace images
