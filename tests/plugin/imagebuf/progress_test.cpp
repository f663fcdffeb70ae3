// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "tests/many_threads.h"
#include "tests/plugin/images.h"

namespace {

using images::make;
using images::window;

using ddt::test::ManyThreads;

/// Twelve tiles.
images::ImageBuf picture(OIIO::TypeDesc type = OIIO::TypeUInt8) {
    auto src = make(1000, 700, 3, type);
    images::fill(src, [](int x, int y, int) { return float((x ^ y) & 255) / 255; });
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    return src;
}

const OIIO::ROI size = window(0, 1500, 0, 1000);

TEST(Progress, RisesToOneOneThreadAtATime) {
    const ManyThreads allowed;
    const auto src = picture();
    for (const int threads : {1, 2, 8}) {
        std::atomic<int> inside{0};
        std::vector<float> shares;
        ddt::Options options;
        options.progress = [&](float share) {
            EXPECT_EQ(++inside, 1);
            shares.push_back(share);
            --inside;
            return true;
        };
        images::ImageBuf dst;
        ASSERT_TRUE(ddt::resize(dst, src, options, size, threads)) << dst.geterror();
        EXPECT_GE(shares.size(), 12u);
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_GT(shares.front(), 0.0f);
        EXPECT_EQ(shares.back(), 1.0f);
    }
}

TEST(Progress, CancelsAtAnyTimeAndLeavesNothing) {
    const ManyThreads allowed;
    const auto src = picture();
    for (const int threads : {1, 2, 8})
        for (const float stop : {0.0f, 0.4f, 1.0f}) {
            int calls_after = 0;
            bool stopped = false;
            ddt::Options options;
            options.progress = [&](float share) {
                calls_after += stopped;
                stopped |= share >= stop;
                return !stopped;
            };
            images::ImageBuf fresh;
            EXPECT_FALSE(ddt::resize(fresh, src, options, size, threads));
            EXPECT_EQ(fresh.geterror(), "ddt: cancelled");
            EXPECT_FALSE(fresh.initialized());
            EXPECT_EQ(calls_after, 0);

            // In an image that was there, the part asked for is black, the rest as it was.
            stopped = false;
            auto dst = make(1500, 1000, 3, OIIO::TypeUInt8);
            images::fill(dst, [](int, int, int) { return 1.0f; });
            OIIO::ROI part = window(200, 1500, 100, 900);
            part.chend = 3;
            EXPECT_FALSE(ddt::resize(dst, src, options, part, threads));
            EXPECT_EQ(dst.geterror(), "ddt: cancelled");
            const auto bytes = images::bytes(dst);
            size_t i = 0;
            for (int y = 0; y < 1000; ++y)
                for (int x = 0; x < 1500; ++x, i += 3)
                    ASSERT_EQ(int(bytes[i]), part.contains(x, y) ? 0 : 255) << x << " " << y;
        }
}

TEST(Progress, IsEachJobsOwn) {
    const auto src = picture();
    std::vector<std::thread> threads;
    std::atomic<int> done{0}, cancelled{0};
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            ddt::Options options;
            float last = 0;
            options.progress = [&, i](float share) {
                EXPECT_GE(share, last);
                last = share;
                return i % 2 == 0 || share < 0.5f;
            };
            images::ImageBuf dst;
            if (ddt::resize(dst, src, options, size, 2)) {
                EXPECT_EQ(last, 1.0f);
                ++done;
            } else {
                EXPECT_EQ(dst.geterror(), "ddt: cancelled");
                ++cancelled;
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(done, 2);
    EXPECT_EQ(cancelled, 2);
}

TEST(Progress, WarpAndMixedResizeToo) {
    const auto src = picture();
    ddt::Options options;
    options.progress = [](float) { return false; };
    images::ImageBuf mixed, turned;
    EXPECT_FALSE(ddt::resize(mixed, src, options, window(0, 1500, 0, 300), 2));
    EXPECT_EQ(mixed.geterror(), "ddt: cancelled");
    EXPECT_FALSE(mixed.initialized());
    const float m[3][3] = {{1.2f, 0.5f, 0}, {-0.5f, 1.2f, 0}, {0, 0, 1}};
    EXPECT_FALSE(ddt::warp(turned, src, m, options, true));
    EXPECT_EQ(turned.geterror(), "ddt: cancelled");
    EXPECT_FALSE(turned.initialized());
}

TEST(Progress, FillingToo) {
    auto src = make(80, 60, 3, OIIO::TypeFloat);
    images::fill(src, [](int x, int y, int) {
        return x > 30 && x < 50 && y > 20 && y < 40 ? std::nanf("") : float(x + y) / 200;
    });
    for (const OIIO::ROI& to : {window(0, 160, 0, 120), window(0, 160, 0, 30), window(0, 40, 0, 30),
                                window(0, 80, 0, 60), OIIO::ROI()}) {
        std::vector<float> shares;
        size_t most = SIZE_MAX;
        ddt::Options options;
        options.holes = ddt::Holes::fill;
        options.progress = [&](float share) {
            shares.push_back(share);
            return shares.size() < most;
        };
        const auto done = [&](images::ImageBuf& dst) {
            shares.clear();
            return to.defined() ? ddt::resize(dst, src, options, to, 2)
                                : ddt::fill(dst, src, options);
        };
        images::ImageBuf dst, cancelled;
        ASSERT_TRUE(done(dst)) << dst.geterror();
        EXPECT_GT(shares.size(), 100u);
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        most = shares.size() / 3;
        EXPECT_FALSE(done(cancelled));
        EXPECT_EQ(cancelled.geterror(), "ddt: cancelled");
        EXPECT_FALSE(cancelled.initialized());
    }
}

} // namespace
