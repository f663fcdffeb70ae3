// SPDX-License-Identifier: Apache-2.0
// Several meshes averaged (MeshOptions::meshes).
#include <cfloat>

#include "core/sample/evaluate.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/job_helpers.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

Job sharp_job(const TestSource& source, int channels, int meshes) {
    Job job = job_of(source, channels);
    job.surface.consistency = 1;
    job.surface.soft = 0.3f;
    job.mesh.blur = 0.05f;
    job.mesh.meshes = meshes;
    return job;
}

TEST(Meshes, AreBlurredByEvenSteps) {
    MeshOptions options = plain_mesh();
    options.blur = 0.1f;
    EXPECT_EQ(blur_share(options, 0), 0.1f);
    options.meshes = 3;
    EXPECT_FLOAT_EQ(blur_share(options, 0), 0.1f - mesh_spread);
    EXPECT_FLOAT_EQ(blur_share(options, 1), 0.1f);
    EXPECT_FLOAT_EQ(blur_share(options, 2), 0.1f + mesh_spread);
    options.meshes = 2;
    options.blur = 0;
    EXPECT_EQ(blur_share(options, 0), 0.0f);
    EXPECT_EQ(blur_share(options, 1), mesh_spread);
    options.blur = 0.25f;
    EXPECT_EQ(blur_share(options, 1), 0.25f);
}

TEST(Meshes, AMeanLiesBetweenItsTwoPartsAndKeepsWhatIsTheSame) {
    Random random(3);
    const float infinity = std::numeric_limits<float>::infinity();
    std::vector<float> mean = {1.0f / 3, -FLT_MAX, FLT_MAX, infinity, 0x1p-80f, 0.0f};
    std::vector<float> last = mean;
    for (int i = 0; i < 5000; ++i) {
        mean.push_back(random.unit() - 0.5f);
        last.push_back(i % 3 ? random.unit() * 1000 : mean.back() * (1 + 0x1p-22f * random.unit()));
    }
    for (const int meshes : {2, 3, 4}) {
        std::vector<float> joined = mean;
        add_to_mean(last.data(), last.size(), 1.0f / float(meshes), joined.data());
        for (size_t i = 0; i < joined.size(); ++i) {
            ASSERT_GE(joined[i], std::min(mean[i], last[i]));
            ASSERT_LE(joined[i], std::max(mean[i], last[i]));
            if (std::fabs(mean[i]) < 1) {
                ASSERT_NEAR(joined[i], mean[i] + (last[i] - mean[i]) / float(meshes), 1e-4);
            }
        }
    }
    mean = {infinity, -0.0f};
    last = {-infinity, -0.0f};
    add_to_mean(last.data(), 2, 0.5f, mean.data());
    EXPECT_EQ(bits_of(mean[0]), 0x7fc00000u);
    EXPECT_EQ(bits_of(mean[1]), 0u);
}

TEST(Meshes, TheResultIsTheMeanOfTheirs) {
    TestSource source({-3, 7, 87, 77}, 3, 4);
    const Rect out{0, 0, 270, 210};
    const auto mapping = mapping_of(source.window(), out, out);
    const Job job = sharp_job(source, 3, 4);
    const auto values = run(source, job, mapping, out);
    std::vector<double> mean(values.size());
    size_t differing_meshes = 0;
    std::vector<float> before;
    for (int k = 0; k < 4; ++k) {
        Job one = job;
        one.mesh.meshes = 1;
        one.mesh.blur = blur_share(job.mesh, k);
        const auto part = run(source, one, mapping, out);
        for (size_t i = 0; i < part.size(); ++i)
            mean[i] += 0.25 * double(part[i]);
        differing_meshes += !before.empty() && differing(part, before) > 0;
        before = part;
    }
    EXPECT_EQ(differing_meshes, 3u);
    for (size_t i = 0; i < values.size(); ++i)
        ASSERT_NEAR(double(values[i]), mean[i], 1e-6);
}

TEST(Meshes, ThreadsPartsAndPositionsOneByOneChangeNothing) {
    const ManyThreads allowed;
    TestSource source({-20, 5, 400, 310}, 3, 1);
    const Rect out{0, 0, 633, 450};
    const auto mapping = mapping_of(source.window(), out, out);
    Job job = sharp_job(source, 3, 3);
    const auto one = run(source, job, mapping, out);
    EXPECT_EQ(differing(run(source, job, Opaque(mapping), out), one), 0u);
    job.threads = 3;
    EXPECT_EQ(differing(run(source, job, mapping, out), one), 0u);
    const Rect part{300, 111, 500, 400};
    const auto values = run(source, job, mapping_of(source.window(), out, part), part);
    for (int y = part.y0; y < part.y1; ++y)
        for (int i = 0; i < part.width() * 3; ++i)
            ASSERT_EQ(values[size_t((y - part.y0) * part.width() * 3 + i)],
                      one[size_t((y * out.width() + part.x0) * 3 + i)]);
}

TEST(Meshes, ConstantsStayAsTheyAre) {
    for (const float value : {0.0f, 0.1f, -3.7f, 4096.3f, 3e38f}) {
        TestSource source({0, 0, 23, 17}, 2, 5);
        for (float& v : source.values())
            v = value;
        const Rect out{0, 0, 61, 50};
        for (int meshes = 2; meshes <= most_meshes; ++meshes) {
            Job job = sharp_job(source, 2, meshes);
            job.surface.consistency =
                0; // of corrected vertices also one mesh may miss the last bit
            for (const float v : run(source, job, mapping_of(source.window(), out, out), out))
                ASSERT_EQ(v, value);
        }
    }
}

TEST(Meshes, WithoutCorrectionsNothingLeavesTheSourcesRange) {
    TestSource source({0, 0, 60, 50}, 1, 6, Kind::few);
    const auto [low, high] = std::minmax_element(source.values().begin(), source.values().end());
    const Rect out{0, 0, 200, 170};
    Job job = sharp_job(source, 1, 3);
    job.surface.consistency = 0;
    for (const float v : run(source, job, mapping_of(source.window(), out, out), out)) {
        ASSERT_GE(v, *low);
        ASSERT_LE(v, *high);
    }
}

TEST(Meshes, AlphaStaysWithinItsRangeAndIdsAreTheFirstMeshs) {
    TestSource source({0, 0, 60, 50}, 4, 8);
    Random random(9);
    for (size_t i = 0; i < source.values().size(); i += 4) {
        source.values()[i + 1] = std::min(1.0f, std::max(0.0f, 3.0f * random.unit() - 1.0f));
        source.values()[i + 3] = float_of(uint32_t(random.bits()) | (i % 3 ? 0x7f800000u : 0u));
    }
    const Rect out{0, 0, 200, 170};
    const auto mapping = mapping_of(source.window(), out, out);
    Job job = sharp_job(source, 4, 3);
    job.surface.limit = 4.0f;
    job.kinds = {Channel::blend, Channel::alpha, Channel::blend, Channel::nearest};
    const auto values = run(source, job, mapping, out);
    job.mesh.blur = blur_share(job.mesh, 0);
    job.mesh.meshes = 1;
    const auto first = run(source, job, mapping, out);
    for (size_t i = 0; i < values.size(); i += 4) {
        ASSERT_GE(values[i + 1], 0.0f);
        ASSERT_LE(values[i + 1], 1.0f);
        ASSERT_EQ(bits_of(values[i + 3]), bits_of(first[i + 3]));
    }
}

TEST(Meshes, IdsOfAnyGroupAreTheFirstMeshs) {
    const int channels = 7;
    TestSource source({0, 0, 40, 30}, channels, 11);
    const Rect out{0, 0, 110, 90};
    const auto mapping = mapping_of(source.window(), out, out);
    Job job = sharp_job(source, channels, 3), blended = job;
    job.kinds.assign(channels, Channel::blend);
    job.kinds[1] = job.kinds[6] = Channel::nearest;
    const auto values = run(source, job, mapping, out);
    const auto means = run(source, blended, mapping, out);
    job.mesh.blur = blur_share(job.mesh, 0);
    job.mesh.meshes = 1;
    const auto first = run(source, job, mapping, out);
    for (size_t i = 0; i < values.size(); ++i) {
        const bool id = i % channels == 1 || i % channels == 6;
        ASSERT_EQ(bits_of(values[i]), bits_of((id ? first : means)[i])) << i % channels;
    }
}

TEST(Meshes, TheirNumberIsBounded) {
    TestSource source({0, 0, 8, 8}, 1, 5);
    const Rect out{0, 0, 16, 16};
    for (const int meshes : {-1, 0, most_meshes + 1}) {
        TestSink sink(out, 1);
        std::string error;
        EXPECT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out),
                          sharp_job(source, 1, meshes), &error),
                  Outcome::bad_job);
        EXPECT_EQ(error, "ddt: option \"meshes=" + std::to_string(meshes) +
                             "\" is not allowed; allowed for meshes are whole numbers from 1 to 4");
    }
}

} // namespace
} // namespace ddt::test
