// SPDX-License-Identifier: Apache-2.0
// The GPU's results against the CPU's, bit for bit.
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <utility>

#include "core/gl/device_mesh.h"
#include "ddt/names.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

std::string name_of(const SurfaceOptions& s) {
    return (s.kind == Surface::linear ? "linear consistency " : "patch consistency ") +
           std::to_string(s.consistency) + " soft " + std::to_string(s.soft) +
           (s.fitted ? " fitted" : "");
}

class SameBits : public OnDevice {};

TEST_P(SameBits, EverySchemeAndCost) {
    for (const MeshOptions& mesh : every_scheme_and_cost())
        for (int content = 0; content < int(Content::count); ++content) {
            const Picture p = make_picture(Content(content), 61, 43, 1, 7u + unsigned(content));
            Order order;
            order.job.mesh = mesh;
            order.job.mesh.contour = content % 2 ? 0.0f : 0.8f;
            order.out_width = 150;
            order.out_height = 101;
            expect_same(GetParam(), p, order,
                        std::string(name_of(Content(content))) + " " + scheme_name(mesh) + " " +
                            cost_name(mesh.cost));
        }
}

// llvmpipe leaves loops that turn too often: a tile is then done in parts.
TEST_P(SameBits, RoundsThatAreMoreThanADispatchCanDo) {
    Picture p = make_picture(Content::photo, 300, 240, 1, 7);
    // Smooth everywhere, so that most edges gain, and wait for one another in long rows.
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            p.guide[size_t(y * p.width + x)] =
                0.5f + 0.4f * std::sin(0.05f * float(x)) * std::cos(0.043f * float(y));
    Order order;
    order.job.mesh.scheme = Scheme::exproi;
    order.out_width = 330;
    order.out_height = 250;
    EXPECT_GT(enlarge_on(Device::cpu, p, order).statistics.rounds, 500);
    expect_same(GetParam(), p, order, "exproi");
}

// The same of iterations that one dispatch finishes.
TEST_P(SameBits, IterationsThatAreMoreThanADispatchCanDo) {
    Picture p = make_picture(Content::photo, 321, 321, 1, 7);
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            p.guide[size_t(y * p.width + x)] =
                0.5f + 0.5f * std::sin(0.02f * (float(x) + 37.3f * float(y)));
    Order order;
    order.job.mesh.blur = order.job.mesh.contour = order.job.mesh.min_gain = 0;
    order.job.mesh.max_iterations = 100;
    order.out_width = order.out_height = 330;
    EXPECT_EQ(enlarge_on(Device::cpu, p, order).statistics.iterations, 100);
    expect_same(GetParam(), p, order, "one_round");
}

TEST_P(SameBits, EverySurface) {
    for (const SurfaceOptions& surface : surfaces_with({0, 1, 2}))
        for (int content = 0; content < int(Content::count); ++content) {
            const Picture p = make_picture(Content(content), 61, 43, 4, 7u + unsigned(content));
            Order order;
            order.job.surface = surface;
            order.job.kinds = {Channel::blend, Channel::blend, Channel::nearest, Channel::alpha};
            order.out_width = 150;
            order.out_height = 101;
            expect_same(GetParam(), p, order,
                        std::string(name_of(Content(content))) + " " + name_of(surface));
        }
}

// A guide that a caller gives may hold anything.
TEST_P(SameBits, GuidesThatAreNotFinite) {
    for (const Scheme scheme : {Scheme::one_round, Scheme::maxgain, Scheme::pixel}) {
        Picture p = make_picture(Content::nonfinite, 61, 43, 3, 7);
        for (size_t i = 0; i < p.guide.size(); ++i)
            p.guide[i] = std::isfinite(p.values[3 * i]) ? p.guide[i] : p.values[3 * i];
        Order order;
        order.job.mesh.scheme = scheme;
        order.job.surface.soft = 0.2f;
        order.out_width = 150;
        order.out_height = 101;
        expect_same(GetParam(), p, order, scheme_name(order.job.mesh));
    }
}

// Where vertices may get negative: that they do, and the same on both.
TEST_P(SameBits, ClippedVertices) {
    for (const bool whole_groups : {false, true}) {
        const Picture p = make_picture(Content::drawing, 61, 43, whole_groups ? 4 : 3, 7);
        Order order;
        order.job.surface.consistency = 2;
        order.job.surface.limit = 0.5f;
        order.out_width = 150;
        order.out_height = 101;
        const auto negative = [&] {
            size_t n = 0;
            for (const uint32_t bits : enlarge_on(Device::cpu, p, order).bits)
                n += bits >> 31;
            return n;
        };
        EXPECT_EQ(negative(), 0u);
        order.job.surface.clipped = true;
        EXPECT_GT(negative(), 100u);
        expect_same(GetParam(), p, order, "clipped");
    }
}

// Fitted ones leave their range by more than the limit where that is black and white.
TEST_P(SameBits, FittedVerticesAtBlackAndWhite) {
    for (const bool whole_groups : {false, true}) {
        Picture p = make_picture(Content::drawing, 61, 43, whole_groups ? 4 : 3, 7);
        for (float& v : p.values)
            v = v > 0.5f ? 1.0f : 0.0f;
        Order order;
        order.job.surface.consistency = 2;
        order.job.surface.fitted = true;
        order.out_width = 150;
        order.out_height = 101;
        const auto far_beyond = [&] {
            size_t n = 0;
            for (const uint32_t bits : enlarge_on(Device::cpu, p, order).bits) {
                float v;
                std::memcpy(&v, &bits, sizeof v);
                n += v < -0.3f || v > 1.3f;
            }
            return n;
        };
        EXPECT_EQ(far_beyond(), 0u);
        order.job.surface.clipped = true;
        EXPECT_GT(far_beyond(), 100u);
        expect_same(GetParam(), p, order, "fitted, clipped");
    }
}

// Along a steep slope that rises by a pixel in forty, edges get longer by a pixel an iteration.
TEST_P(SameBits, IterationsThatAreNotDispatched) {
    Picture p = make_picture(Content::drawing, 160, 48, 4, 7);
    for (size_t i = 0; i < p.guide.size(); ++i) {
        const float height = float(i / 160) - float(i % 160) * 0.025f - 22.0f;
        p.guide[i] = height < 0 ? 0 : height < 2 ? height * 0.5f : 1;
    }
    Order order;
    order.job.mesh.contour = 0.8f;
    order.out_width = 400;
    order.out_height = 120;
    EXPECT_GT(enlarge_on(Device::cpu, p, order).statistics.iterations,
              gl::dispatched_iterations + 3);
    expect_same(GetParam(), p, order, "late iterations");
}

TEST_P(SameBits, TilesThatAreMoreThanADispatchCanDo) {
    const int most = 65535; // groups along an axis, of 16 columns or 8 rows
    Order order;
    order.job.surface = plain_surface(Surface::linear);
    const Picture tall = make_picture(Content::photo, 3, 200, 1, 5);
    order.out_width = 3;
    order.out_height = most * 8 + 100;
    expect_same(GetParam(), tall, order, "tall");
    const Picture wide = make_picture(Content::photo, 200, 3, 1, 6);
    order.out_height = 3;
    order.out_width = most * 16;
    expect_same(GetParam(), wide, order, "wide");
    order.out_width += 1; // left to the CPU before anything is done
    const Result result = enlarge_on(GetParam(), wide, order);
    EXPECT_EQ(result.outcome, Outcome::done) << result.error;
    EXPECT_EQ(result.statistics.device, Device::cpu);
}

TEST_P(SameBits, SeveralMeshes) {
    for (const int channels : {3, 4})
        for (const Scheme scheme : {Scheme::one_round, Scheme::lawson})
            for (int content = 0; content < int(Content::count); ++content) {
                const Picture p =
                    make_picture(Content(content), 61, 43, channels, 7u + unsigned(content));
                Order order;
                order.job.mesh.scheme = scheme;
                order.job.mesh.blur = 0.05f;
                order.job.mesh.meshes = 2 + content % 3;
                order.job.mesh.contour = 0.4f;
                order.job.surface.consistency = 1;
                order.job.surface.soft = 0.3f;
                if (channels == 4)
                    order.job.kinds = {Channel::blend, Channel::blend, Channel::nearest,
                                       Channel::alpha};
                order.out_width = 150;
                order.out_height = 101;
                expect_same(GetParam(), p, order,
                            std::string(name_of(Content(content))) + " " +
                                std::to_string(order.job.mesh.meshes) + " meshes");
            }
}

/// Who gives pixels, takes them or is told of progress may have the same device do other things.
TEST_P(SameBits, OfJobsWithinJobs) {
    const Picture p = make_picture(Content::photo, 600, 300, 1, 7);
    const Picture inner = make_picture(Content::noise, 40, 30, 3, 9);
    Order order, small;
    order.out_width = small.out_width = 700;
    order.out_height = small.out_height = 310;
    const Result alone = enlarge_on(Device::cpu, inner, small);
    std::atomic<int> jobs{0};
    const auto enlarge_another = [&] {
        const Result within = enlarge_on(GetParam(), inner, small);
        EXPECT_EQ(within.statistics.device, GetParam()) << within.error;
        EXPECT_EQ(within.bits, alone.bits);
        ++jobs;
    };
    class Using final : public Source, public Sink {
    public:
        Using(Source& source, Sink& sink, std::function<void()> use)
            : m_source(source), m_sink(sink), m_use(std::move(use)) {}
        bool read(const Rect& r, float* values, float* guide) override {
            m_use();
            return m_source.read(r, values, guide);
        }
        bool write(const Rect& r, float* values) override {
            if (r.y0 % 64 == 0)
                m_use();
            return m_sink.write(r, values);
        }

    private:
        Source& m_source;
        Sink& m_sink;
        std::function<void()> m_use;
    };
    const Result expected = enlarge_on(Device::cpu, p, order);
    const ResizeMapping mapping(ResizeMapping::Axis::whole(p.width, order.out_width),
                                ResizeMapping::Axis::whole(p.height, order.out_height));
    BufferSource source = source_of(p);
    BitsSink sink(order.out_width, order.out_height, 1);
    Using user(source, sink, enlarge_another);
    Job job = order.job;
    job.window = {0, 0, p.width, p.height};
    job.channels = 1;
    job.device = GetParam();
    job.threads = 3;
    Statistics statistics;
    job.statistics = &statistics;
    job.progress = [&](float) {
        enlarge_another();
        return true;
    };
    std::string error;
    ASSERT_EQ(enlarge(user, user, mapping, job, &error), Outcome::done) << error;
    EXPECT_EQ(statistics.device, GetParam());
    EXPECT_GT(jobs, 10);
    EXPECT_EQ(sink.bits, expected.bits);
}

INSTANTIATE_TEST_SUITE_P(Devices, SameBits, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test
