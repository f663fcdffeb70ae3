// SPDX-License-Identifier: Apache-2.0
// Sixteen threads of a program that all use the libraries at once, as a host's do. Compiled with
// the thread sanitizer (CMakeLists.txt) races are found; everywhere each thread must get the bits
// that it gets alone.
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "ddt/core.h"
#include "ddt/log.h"
#include "ddt/option_table.h"
#include "ddt/resize.h"

namespace ddt {
namespace {

using OIIO::ImageBuf;

constexpr int threads = 16, width = 300, height = 24;

/// A round light on stripes, other ones for each n.
ImageBuf picture(int n, OIIO::TypeDesc type = OIIO::TypeFloat) {
    OIIO::ImageSpec spec(width, height, 3, type);
    spec.attribute("oiio:ColorSpace", n % 2 ? "sRGB" : "linear");
    ImageBuf image(spec);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const float x = float(i - 30 - n), y = float(j - 12);
            const float stripes = 0.5f + 0.25f * std::sin(0.3f * (x + y));
            const float light = x * x + y * y < 120 ? 0.25f : 0.0f;
            image.setpixel(i, j, {stripes, stripes + 0.5f * light, stripes + light});
        }
    return image;
}

using Bits = std::vector<float>;

Bits pixels(const ImageBuf& image) {
    Bits bits(size_t(image.spec().image_pixels()) * size_t(image.nchannels()));
    EXPECT_TRUE(image.get_pixels(image.roi(), OIIO::TypeFloat, bits.data()));
    return bits;
}

/// One thing that a program does with the libraries: the result of doing the nth.
using Act = std::function<Bits(int n)>;

Bits resized(const ImageBuf& source, const char* filter, int nthreads, int to_width = 3 * width / 2,
             int to_height = 2 * height) {
    Options options;
    std::string error;
    EXPECT_TRUE(parse_filter(filter, options, error)) << error;
    options.device = Device::cpu;
    Statistics statistics;
    options.statistics = &statistics;
    ImageBuf result;
    EXPECT_TRUE(resize(result, source, options, OIIO::ROI(0, to_width, 0, to_height), nthreads))
        << result.geterror();
    EXPECT_GT(statistics.pixels, 0);
    return pixels(result);
}

const Act acts[] = {
    [](int n) { return resized(picture(n), "ddt", 3); },
    [](int n) { return resized(picture(n, OIIO::TypeUInt8), "ddt-sharp", 2); },
    [](int n) { return resized(picture(n), "ddt-linear,scheme=maxgain,cost=scf", 1); },
    [](int n) { return resized(picture(n), "ddt,meshes=3", 2); },
    [](int n) { // more threads than tiles: they share rows
        return resized(picture(n), n % 2 ? "ddt" : "ddt-sharp", 4, 6 * width, 6 * height);
    },
    [](int n) { // one source for all
        static const ImageBuf shared = picture(4);
        return resized(shared, n % 2 ? "ddt" : "ddt-sharp", 2);
    },
    [](int n) { // another colour space each time, so that each is analysed
        ImageBuf image = picture(n);
        image.specmod().attribute("oiio:ColorSpace", "Gamma" + std::to_string(1.5 + 0.01 * n));
        return resized(image, "ddt", 2);
    },
    [](int n) {
        Options options;
        options.device = Device::cpu;
        const float M[3][3] = {{2, 0.3f, 0}, {-0.3f, 2, 0}, {float(n), 0, 1}};
        ImageBuf result;
        EXPECT_TRUE(warp(result, picture(n), M, options, true, ImageBuf::WrapDefault, {}, 2))
            << result.geterror();
        return pixels(result);
    },
    [](int n) {
        std::string error;
        Options options;
        EXPECT_FALSE(parse_filter("ddt,cost=none", options, error));
        // Each another name: OpenImageIO's cache writes a broken file's message into a record that
        // all who ask for the file share, and does so without a lock.
        ImageBuf unread("does not exist " + std::to_string(n)), result;
        EXPECT_FALSE(resize(result, unread, options));
        return Bits{float(error.size()), float(n)};
    },
};

bool same(const Bits& a, const Bits& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(Threads, SixteenAtOnceGetWhatEachGetsAlone) {
    constexpr int rounds = 2, kinds = int(std::size(acts));
    std::vector<Bits> got(threads * rounds);
    std::atomic<int> waiting{threads}, lines{0};
    set_log([&](const char*) { ++lines; });
    // All begin their first call together: what is found out once is found out by all of them.
    std::vector<std::thread> all;
    for (int t = 0; t < threads; ++t)
        all.emplace_back([&, t] {
            for (--waiting; waiting > 0;)
                std::this_thread::yield();
            for (int n = 0; n < rounds; ++n) {
                if (t == 5) // while others tell
                    set_log([&](const char*) { ++lines; });
                got[size_t(t * rounds + n)] = acts[(t + n) % kinds](t * rounds + n);
            }
        });
    for (std::thread& one : all)
        one.join();
    set_log(nullptr);
    for (int t = 0; t < threads; ++t)
        for (int n = 0; n < rounds; ++n)
            EXPECT_TRUE(same(got[size_t(t * rounds + n)], acts[(t + n) % kinds](t * rounds + n)))
                << "thread " << t << ", call " << n;
}

} // namespace
} // namespace ddt
