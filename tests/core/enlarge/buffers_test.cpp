// SPDX-License-Identifier: Apache-2.0
#include "ddt/core.h"

#include <cmath>

#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

TEST(Buffers, SameAsTheJobTheyStandFor) {
    TestSource source({0, 0, 280, 50}, 3, 1);
    const Rect out{0, 0, 420, 110};
    for (const Surface surface : both_surfaces)
        for (const Scheme scheme : {Scheme::one_round, Scheme::lawson, Scheme::pixel}) {
            Job job = job_of(source, 3);
            job.surface = plain_surface(surface);
            job.mesh.scheme = scheme;
            TestSink sink(out, 3);
            ASSERT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out), job),
                      Outcome::done);
            std::vector<float> dst(out.area() * 3);
            std::string error = "left over";
            ASSERT_EQ(enlarge(source.values().data(), 280, 50, 3, source.guide().data(), dst.data(),
                              420, 110, job.surface, job.mesh, 2, &error),
                      Outcome::done);
            EXPECT_EQ(error, "");
            ASSERT_EQ(differing(dst, sink.values()), 0u);
        }
}

TEST(Buffers, WithoutAGuideTheMeanOfTheFirstThreeChannelsServes) {
    for (const int channels : {1, 2, 3, 4}) {
        TestSource source({0, 0, 20, 20}, channels, 2, Kind::noise);
        std::vector<float> guide;
        for (size_t i = 0; i < 400; ++i) {
            const float* p = &source.values()[i * size_t(channels)];
            guide.push_back(channels < 3 ? p[0] : (p[0] + p[1] + p[2]) * (1.0f / 3.0f));
        }
        const auto values = [&](const float* g) {
            std::vector<float> dst(size_t(60 * 60 * channels));
            EXPECT_EQ(enlarge(source.values().data(), 20, 20, channels, g, dst.data(), 60, 60),
                      Outcome::done);
            return dst;
        };
        EXPECT_EQ(differing(values(nullptr), values(guide.data())), 0u);
        std::vector<float> other = guide;
        std::reverse(other.begin(), other.end());
        EXPECT_NE(differing(values(nullptr), values(other.data())), 0u);
    }
}

TEST(Buffers, NumbersNearerToZeroThanIsSaidCountAsZero) {
    const std::vector<float> guide(16, 0.5f);
    for (const float value : {0x1p-80f, -0x1p-80f, 0x1.fffffep-81f, -0x1.fffffep-81f, 0x1p-140f}) {
        const std::vector<float> src(16, value);
        std::vector<float> dst(64, 1.0f);
        ASSERT_EQ(enlarge(src.data(), 4, 4, 1, guide.data(), dst.data(), 8, 8), Outcome::done);
        const float expected = std::fabs(value) < 0x1p-80f ? 0.0f : value;
        for (const float v : dst)
            ASSERT_EQ(v, expected) << value;
    }
}

TEST(Buffers, BadArgumentsAreAnError) {
    std::vector<float> src(16), dst(64);
    std::string error;
    const auto outcome = [&](const float* from, int w, int h, int channels, float* to, int dw,
                             int dh) {
        error.clear();
        const Outcome o = enlarge(from, w, h, channels, nullptr, to, dw, dh, plain_surface(),
                                  MeshOptions(), 1, &error);
        EXPECT_EQ(o == Outcome::done, error.empty());
        EXPECT_EQ(enlarge(from, w, h, channels, nullptr, to, dw, dh), o);
        return o;
    };
    EXPECT_EQ(outcome(src.data(), 4, 4, 1, dst.data(), 8, 8), Outcome::done);
    EXPECT_EQ(outcome(src.data(), 4, 4, 1, dst.data(), 3, 8), Outcome::bad_job);
    EXPECT_EQ(outcome(src.data(), 4, 4, 1, dst.data(), 8, 3), Outcome::bad_job);
    EXPECT_EQ(outcome(nullptr, 4, 4, 1, dst.data(), 8, 8), Outcome::bad_job);
    EXPECT_EQ(outcome(src.data(), 4, 4, 1, nullptr, 8, 8), Outcome::bad_job);
    EXPECT_EQ(outcome(src.data(), 0, 4, 1, dst.data(), 8, 8), Outcome::bad_job);
    EXPECT_EQ(outcome(src.data(), 4, -1, 1, dst.data(), 8, 8), Outcome::bad_job);
    EXPECT_EQ(outcome(src.data(), 4, 4, 0, dst.data(), 8, 8), Outcome::bad_job);
}

} // namespace
} // namespace ddt::test
