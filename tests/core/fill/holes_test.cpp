// SPDX-License-Identifier: Apache-2.0
// Job::holes: as fill_holes() and then as any other picture.
#include <cmath>
#include <utility>

#include "core/fill/fill.h"
#include "core/fill/membrane.h"
#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

constexpr int width = 90, height = 70, channels = 3;
constexpr int left = -7, top = 11; // of the window

/// Twice as large.
Outcome twice(TestSource& source, Holes holes, Device device, std::vector<float>& result,
              std::string& error, const ProgressCallback& progress = {}, int threads = 0) {
    Job job;
    job.window = source.window();
    job.channels = channels;
    job.kinds = {Channel::blend, Channel::nearest, Channel::alpha};
    job.holes = holes;
    job.device = device;
    job.progress = progress;
    job.threads = threads;
    const Rect out{0, 0, 2 * width, 2 * height};
    TestSink sink(out, channels);
    const Outcome outcome =
        enlarge(source, sink, mapping_of(source.window(), out, out), job, &error);
    result = sink.values();
    return outcome;
}

TestSource source_of(std::vector<float> values, std::vector<float> guide) {
    return TestSource({left, top, left + width, top + height}, channels, std::move(values),
                      std::move(guide));
}

TestSource picture() {
    Random random(7);
    std::vector<float> values, guide;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float v = (3 * x + 5 * y) % 41 < 17 ? 0.9f : 0.01f * float(random.below(30));
            values.insert(values.end(), {v, float(x / 7), 1.0f});
            guide.push_back(v);
        }
    return source_of(std::move(values), std::move(guide));
}

TEST(JobHoles, AreFilledAsFillHolesDoesAndTheMeshSeesThemSo) {
    TestSource holed = picture();
    for (int y = 20; y < 41; ++y)
        for (int x = 30; x < 49; ++x) {
            holed.values()[size_t(y * width + x) * channels] = std::nanf("");
            holed.guide()[size_t(y * width + x)] = std::nanf("");
        }
    // In a corner, where there are no triangles: as the nearest pixel, its guide too.
    for (int y = 63; y < height; ++y)
        for (int x = 0; x < 9; ++x) {
            holed.values()[size_t(y * width + x) * channels] = std::nanf("");
            holed.guide()[size_t(y * width + x)] = std::nanf("");
        }
    for (int y = 50; y < 61; ++y)
        for (int x = 30; x < 46; ++x) {
            holed.values()[size_t(y * width + x) * channels + 1] = -1;
            holed.values()[size_t(y * width + x) * channels + 2] = 0;
        }
    holed.values()[5 * channels + 2] = 0;             // alpha
    holed.values()[9 * channels + 1] = std::nanf(""); // an ID is what it is
    for (const Holes holes : {Holes::fill, Holes::fill_alpha}) {
        TestSource filled = source_of(holed.values(), holed.guide());
        std::string error;
        ASSERT_TRUE(fill_missing(
            {filled.values().data(), filled.guide().data(), filled.guide().data(), width, height,
             channels, std::vector{Channel::blend, Channel::nearest, Channel::alpha}.data()},
            holes, MeshOptions(), Device::cpu, {}, nullptr, error))
            << error;
        for (size_t i = 0; i < filled.guide().size(); ++i) {
            EXPECT_TRUE(std::isfinite(filled.guide()[i]));
            EXPECT_TRUE(std::isfinite(filled.values()[i * channels]));
        }
        // IDs are those of the hole's rim, none between two and no other channel's number.
        for (int y = 50; y < 61; ++y)
            for (int x = 30; x < 46 && holes == Holes::fill_alpha; ++x) {
                const float id = filled.values()[size_t(y * width + x) * channels + 1];
                EXPECT_EQ(id, std::floor(id));
                EXPECT_TRUE(id >= 29 / 7 && id <= 46 / 7) << x << ' ' << y << ": " << id;
            }
        EXPECT_EQ(filled.values()[5 * channels + 2], holes == Holes::fill ? 0.0f : 1.0f);
        EXPECT_TRUE(std::isnan(filled.values()[9 * channels + 1]));
        filled.values()[9 * channels + 1] = holed.values()[9 * channels + 1] = 4;
        std::vector<float> a, b;
        ASSERT_EQ(twice(holed, holes, Device::cpu, a, error), Outcome::done) << error;
        ASSERT_EQ(twice(filled, Holes::keep, Device::cpu, b, error), Outcome::done) << error;
        EXPECT_EQ(a, b);
        holed.values()[9 * channels + 1] = std::nanf("");
    }
}

TEST(JobHoles, ProgressRisesAndCancelsAtAnyCall) {
    TestSource holed = picture();
    for (int y = 20; y < 41; ++y)
        for (int x = 30; x < 49; ++x)
            holed.values()[size_t(y * width + x) * channels] = std::nanf("");
    const ManyThreads allowed;
    std::vector<float> shares;
    // Returns the outcome; `last`: the call that cancels.
    const auto run = [&](Holes holes, size_t last, std::vector<float>& result, std::string& error) {
        shares.clear();
        return twice(
            holed, holes, Device::cpu, result, error,
            [&](float share) {
                shares.push_back(share);
                return shares.size() < last;
            },
            3);
    };
    std::vector<float> unwatched, watched;
    std::string error;
    ASSERT_EQ(twice(holed, Holes::fill, Device::cpu, unwatched, error), Outcome::done) << error;
    ASSERT_EQ(run(Holes::fill, SIZE_MAX, watched, error), Outcome::done) << error;
    EXPECT_EQ(watched, unwatched);
    const size_t calls = shares.size();
    EXPECT_GT(calls, 100u);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0f);
    for (const size_t last : {size_t(1), size_t(2), calls / 2, calls - 1, calls}) {
        EXPECT_EQ(run(Holes::fill, last, watched, error), Outcome::cancelled) << last;
        EXPECT_EQ(error, "ddt: cancelled");
        EXPECT_EQ(shares.size(), last);
    }
    // Of reading, and before the mesh is made, which nothing can stop.
    EXPECT_LT(shares[0], 0.02f);
    EXPECT_GE(std::count_if(shares.begin(), shares.end(), [](float s) { return s < 0.02f; }), 3);
    // Where nothing is missing nothing is said to have been filled.
    holed.values() = picture().values();
    ASSERT_EQ(run(Holes::fill, SIZE_MAX, watched, error), Outcome::done) << error;
    ASSERT_EQ(shares.size(), 3u); // two bands of rows, and the tile
    EXPECT_LT(shares[1], 0.02f);
    EXPECT_EQ(shares[2], 1.0f);
}

TEST(FillHoles, ProgressEndsAtAllAndCancelsThereToo) {
    constexpr int side = 40;
    std::vector<float> shares;
    size_t last = SIZE_MAX;
    const auto filled = [&](bool corner, std::string& error) {
        std::vector<float> values(side * side, 0.5f), guide(values.size());
        std::vector<uint8_t> missing(values.size());
        for (int y = 0; y < 9; ++y)
            std::fill_n(&missing[size_t((corner ? y : y + 15) * side + (corner ? 0 : 15))], 9,
                        uint8_t(1));
        shares.clear();
        return fill_holes(values.data(), side, side, 1, nullptr, guide.data(), missing.data(),
                          plain_mesh(), &error, [&](float share) {
                              shares.push_back(share);
                              return shares.size() < last;
                          });
    };
    for (const bool corner : {false, true}) {
        std::string error;
        last = SIZE_MAX;
        ASSERT_TRUE(filled(corner, error)) << error;
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_EQ(shares.back(), 1.0f);
        last = shares.size();
        EXPECT_FALSE(filled(corner, error));
        EXPECT_EQ(error, "ddt: cancelled");
        EXPECT_EQ(shares.size(), last);
    }
}

/// Single pixels all over it, and a hole larger than those that share meshes.
TEST(FillHoles, HasTheSameBitsByAnyNumberOfThreads) {
    constexpr int side = 210;
    Random random(5);
    std::vector<float> whole(side * side), values;
    std::vector<uint8_t> missing(whole.size());
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const size_t i = size_t(y * side + x);
            whole[i] = float((3 * x + 5 * y) % 41 < 17) + 0.01f * float(random.below(20));
            missing[i] = random.below(20) == 0 || (x > 90 && x < 190 && y > 70 && y < 100);
        }
    const ManyThreads allowed;
    std::vector<float> first;
    for (const int threads : {1, 3, 8}) {
        values = whole;
        for (size_t i = 0; i < values.size(); ++i)
            if (missing[i])
                values[i] = std::nanf("");
        std::vector<float> guide = values;
        std::string error;
        MeshReport report;
        ASSERT_TRUE(
            fill_holes({values.data(), guide.data(), guide.data(), side, side, 1, nullptr, threads},
                       missing.data(), plain_mesh(), Device::cpu, {}, &report, error))
            << error;
        for (size_t i = 0; i < values.size(); ++i)
            EXPECT_TRUE(missing[i] ? values[i] >= 0 && values[i] <= 1.2f : values[i] == whole[i]);
        EXPECT_GT(report.statistics.flips, 0);
        EXPECT_LT(report.cost, report.cost_start);
        if (first.empty())
            first = values;
        EXPECT_EQ(values, first) << threads;
    }
}

/// What is missing far away changes nothing: meshes are those of the holes about a pixel.
TEST(FillHoles, HolesFarAwayChangeNothing) {
    constexpr int side = 300;
    Random random(6);
    std::vector<float> whole(side * side);
    for (float& v : whole)
        v = 0.01f * float(random.below(100));
    const auto filled = [&](bool more) {
        std::vector<float> values = whole;
        std::vector<uint8_t> missing(whole.size());
        for (int y = 10; y < 40; y += 3)
            missing[size_t(y * side + y)] = 1;
        if (more)
            for (int y = 200; y < 290; ++y)
                std::fill_n(&missing[size_t(y * side + 180)], 90, uint8_t(1));
        std::string error;
        EXPECT_TRUE(fill_holes(values.data(), side, side, 1, nullptr, whole.data(), missing.data(),
                               plain_mesh(), &error))
            << error;
        values.resize(size_t(150 * side));
        return values;
    };
    EXPECT_EQ(filled(false), filled(true));
}

/// Beside a hole, one of them and both: what others give is finite.
TEST(FillHoles, InfinitiesAreNoPartOfWhatOthersGive) {
    constexpr int side = 40;
    const auto in_hole = [](int x, int y) { return x >= 15 && x < 25 && y >= 14 && y < 26; };
    const auto filled = [&](bool infinite) {
        std::vector<float> values(side * side), guide(values.size());
        std::vector<uint8_t> missing(values.size());
        Random random(7);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto i = size_t(y * side + x);
                values[i] = guide[i] = 0.1f * float(random.below(10));
                missing[i] = in_hole(x, y);
                if (infinite && x >= 15 && x < 25 && (y == 13 || y == 26))
                    values[i] = y == 13 ? INFINITY : -INFINITY;
            }
        const std::vector<float> before = values;
        std::string error;
        EXPECT_TRUE(fill_holes(values.data(), side, side, 1, nullptr, guide.data(), missing.data(),
                               plain_mesh(), &error))
            << error;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto i = size_t(y * side + x);
                if (in_hole(x, y))
                    EXPECT_TRUE(values[i] >= 0 && values[i] <= 0.1f * 9) << x << " " << y;
                else
                    EXPECT_EQ(values[i], before[i]);
            }
    };
    filled(false);
    filled(true);
}

/// What counts as 0 elsewhere does where holes are filled, too.
TEST(FillHoles, AGuideThatIsNoUsualNumberCountsAs0) {
    constexpr int side = 40;
    const auto filled = [&](float odd) {
        std::vector<float> values(side * side), guide(values.size());
        std::vector<uint8_t> missing(values.size());
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto i = size_t(y * side + x);
                values[i] = guide[i] = (x + y / 2) / 7 % 2 ? 0.9f : 0.1f;
                missing[i] = x >= 12 && x < 26 && y >= 12 && y < 26;
                if (x >= 17 && x < 20 && y == 11)
                    guide[i] = odd;
            }
        const std::vector<float> given = guide;
        std::string error;
        EXPECT_TRUE(fill_holes(values.data(), side, side, 1, nullptr, guide.data(), missing.data(),
                               plain_mesh(), &error))
            << error;
        EXPECT_EQ(differing(guide, given), 0u);
        return values;
    };
    const std::vector<float> with_0 = filled(0);
    EXPECT_NE(filled(0.9f), with_0);
    for (const float odd : {INFINITY, -INFINITY, std::nanf(""), 1e-9f})
        EXPECT_EQ(filled(odd), with_0) << odd;
}

/// Of infinities alone, of both signs, they are what is there.
TEST(FillHoles, IsNoNumberOfNothing) {
    constexpr int side = 20;
    std::vector<float> values(side * side), guide(values.size(), 0.5f);
    std::vector<uint8_t> missing(values.size());
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            values[size_t(y * side + x)] = y < side / 2 ? INFINITY : -INFINITY;
            missing[size_t(y * side + x)] = x > 5 && x < 14 && y > 5 && y < 14;
        }
    std::string error;
    ASSERT_TRUE(fill_holes(values.data(), side, side, 1, nullptr, guide.data(), missing.data(),
                           plain_mesh(), &error))
        << error;
    for (const float v : values)
        EXPECT_TRUE(std::isinf(v)) << v;
}

/// A step across a hole 24 pixels wide, and noise on its rim.
TEST(SmoothHoles, TakesStreaksAndLeavesEdgesAndRanges) {
    constexpr int side = 24;
    std::vector<float> values, guide;
    std::vector<uint8_t> filled, known(side * side, 1);
    Random random(3);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const float step = x < side / 2 ? 0.0f : 1.0f;
            const bool rim = x == 0 || y == 0 || x == side - 1 || y == side - 1;
            const float noise = 0.001f * float(random.below(40)) * (step > 0 ? -1.0f : 1.0f);
            filled.push_back(!rim);
            guide.push_back(step + noise);
        }
    values = guide;
    HoledImage image{values.data(), guide.data(), nullptr, side, side, 1, nullptr, 1};
    smooth_holes(image, filled, known, guide);
    double rough = 0, was = 0;
    for (int y = 3; y < side - 3; ++y)
        for (int x = 3; x < side - 3; ++x) {
            const size_t i = size_t(y * side + x);
            EXPECT_NEAR(values[i], x < side / 2 ? 0.02 : 0.98, 0.02);
            EXPECT_TRUE(values[i] >= 0 && values[i] <= 1);
            rough += std::fabs(values[i] - values[i + side]);
            was += std::fabs(guide[i] - guide[i + side]);
        }
    EXPECT_LT(rough, 0.2 * was);
    // Beside what was there nothing changes.
    for (int x = 1; x < side - 1; ++x)
        EXPECT_EQ(values[size_t(side + x)], guide[size_t(side + x)]);
    // By many threads as by one.
    const std::vector<float> smoothed = values;
    for (const int threads : {1, 3, 8}) {
        values = guide;
        image.threads = threads;
        smooth_holes(image, filled, known, guide);
        EXPECT_EQ(values, smoothed) << threads;
    }
    // What is not finite stays, and does not spread.
    values = guide;
    values[side * 10 + 5] = INFINITY;
    smooth_holes(image, filled, known, guide);
    EXPECT_TRUE(std::isinf(values[side * 10 + 5]));
    EXPECT_TRUE(std::isfinite(values[side * 10 + 6]));
}

} // namespace
} // namespace ddt::test
