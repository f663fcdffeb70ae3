// SPDX-License-Identifier: Apache-2.0
// No exception of user code, of whatever type, leaves the library.
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/fill/fill.h"
#include "ddt/mesh.h"
#include "ddt/points.h"
#include "tests/core/job_helpers.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

enum class Thrown { error, memory, number };

void throw_it(Thrown what) {
    switch (what) {
    case Thrown::error:
        throw std::runtime_error("a line that is longer than any string keeps within itself");
    case Thrown::memory:
        throw std::bad_alloc();
    case Thrown::number:
        throw 42;
    }
}

enum class Where { source, sink, reach, row, progress };

class ThrowingSource final : public Source {
public:
    explicit ThrowingSource(Thrown what) : m_what(what) {}
    bool read(const Rect&, float*, float*) override {
        throw_it(m_what);
        return true;
    }

private:
    Thrown m_what;
};

class ThrowingSink final : public Sink {
public:
    explicit ThrowingSink(Thrown what) : m_what(what) {}
    bool write(const Rect&, float*) override {
        throw_it(m_what);
        return true;
    }

private:
    Thrown m_what;
};

class ThrowingMapping final : public Mapping {
public:
    ThrowingMapping(const Mapping& mapping, Where where, Thrown what)
        : m_mapping(mapping), m_where(where), m_what(what) {}
    Rect reach(double x0, double y0, double x1, double y1) const override {
        if (m_where == Where::reach)
            throw_it(m_what);
        return m_mapping.reach(x0, y0, x1, y1);
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        if (m_where == Where::row)
            throw_it(m_what);
        m_mapping.row(y, x0, x1, positions, inside);
    }

private:
    const Mapping& m_mapping;
    Where m_where;
    Thrown m_what;
};

// Noexcept is a promise to callers, and what is not guarded whole would end the process.
static_assert(noexcept(enlarge(std::declval<Source&>(), std::declval<Sink&>(),
                               std::declval<const Mapping&>(), std::declval<const Job&>())));
static_assert(noexcept(enlarge(nullptr, 0, 0, 0, nullptr, nullptr, 0, 0)));
static_assert(noexcept(build_mesh(nullptr, 0, 0, {}, std::declval<Mesh&>())));
static_assert(noexcept(delaunay(std::declval<PointMesh&>())));
static_assert(noexcept(optimise(std::declval<PointMesh&>(), nullptr, {})));
static_assert(noexcept(draw(std::declval<PointMesh&>(), nullptr, 0, {}, nullptr, nullptr)));
static_assert(noexcept(fill_holes(nullptr, 0, 0, 0, nullptr, nullptr, nullptr, {})));

void expect_line(const std::string& error) {
    EXPECT_EQ(error.rfind("ddt: ", 0), 0u) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

TEST(Throwing, EnlargeNeverDoes) {
    const ManyThreads allowed;
    const Rect window{0, 0, 600, 40}, out{0, 0, 700, 80};
    TestSource source(window, 1, 3);
    const ResizeMapping mapping = mapping_of(window, out, out);
    for (const int threads : {1, 3})
        for (const Thrown what : {Thrown::error, Thrown::memory, Thrown::number})
            for (const Where where :
                 {Where::source, Where::sink, Where::reach, Where::row, Where::progress}) {
                Job job = job_of(source, 1, threads);
                job.device = Device::cpu;
                if (where == Where::progress)
                    job.progress = [&](float) {
                        throw_it(what);
                        return true;
                    };
                ThrowingSource bad_source(what);
                ThrowingSink bad_sink(what);
                TestSink sink(out, 1);
                std::string error;
                const Outcome outcome =
                    enlarge(where == Where::source ? static_cast<Source&>(bad_source) : source,
                            where == Where::sink ? static_cast<Sink&>(bad_sink) : sink,
                            ThrowingMapping(mapping, where, what), job, &error);
                EXPECT_EQ(outcome,
                          what == Thrown::memory ? Outcome::out_of_memory : Outcome::bad_job);
                expect_line(error);
            }
}

/// Throws when it is first read.
class OnceThrowingSource final : public Source {
public:
    explicit OnceThrowingSource(Source& source) : m_source(source) {}
    bool read(const Rect& r, float* values, float* guide) override {
        if (reads++ == 0)
            throw_it(Thrown::error);
        return m_source.read(r, values, guide);
    }
    std::atomic<int> reads{0};

private:
    Source& m_source;
};

TEST(Throwing, EndsTheWorkOfOtherThreadsToo) {
    const ManyThreads allowed;
    const Rect window{0, 0, 40 * 256, 300}, out{0, 0, 40 * 256, 600};
    TestSource source(window, 1, 3, Kind::noise);
    OnceThrowingSource once(source);
    TestSink sink(out, 1);
    Job job = job_of(source, 1, 2);
    job.device = Device::cpu;
    EXPECT_EQ(enlarge(once, sink, mapping_of(window, out, out), job, nullptr), Outcome::bad_job);
    EXPECT_LT(once.reads, 2 * 40);
}

/// Throws at its call number `last`, which others wait for.
struct CountedProgress {
    int last;
    std::atomic<int> calls{0};
    ProgressCallback tell() {
        return [this](float) {
            if (++calls < last)
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            throw std::runtime_error("enough");
        };
    }
};

TEST(Throwing, ProgressIsNotCalledAgain) {
    const ManyThreads allowed;
    const Rect window{0, 0, 600, 600};
    TestSource source(window, 1, 3);
    std::vector<uint8_t> missing(window.area());
    for (size_t i = 0; i < missing.size(); ++i)
        missing[i] = i % 5 == 0 && i / 600 % 3 == 0;
    TestSource holed(window, 1, 3);
    for (size_t i = 0; i < missing.size(); ++i)
        if (missing[i])
            holed.values()[i] = std::nanf("");
    for (const int last : {1, 2, 3, 30, 300}) {
        CountedProgress filling{last};
        std::vector<float> values = source.values(), guide = source.guide();
        const HoledImage image{values.data(), guide.data(), guide.data(), 600, 600, 1, nullptr, 4};
        std::string error;
        EXPECT_THROW(
            fill_holes(image, missing.data(), {}, Device::cpu, filling.tell(), nullptr, error),
            std::runtime_error);
        EXPECT_EQ(filling.calls, last);
        for (TestSource* from : {&source, &holed}) {
            CountedProgress enlarging{from == &source ? std::min(last, 3) : last};
            Job job = job_of(*from, 1, 4);
            job.device = Device::cpu;
            job.holes = Holes::fill;
            job.progress = enlarging.tell();
            TestSink sink(window, 1);
            EXPECT_EQ(enlarge(*from, sink, mapping_of(window, window, window), job, &error),
                      Outcome::bad_job);
            EXPECT_EQ(error, "ddt: enough");
            EXPECT_EQ(enlarging.calls, enlarging.last);
        }
    }
}

TEST(Throwing, BuildMeshNeverDoes) {
    const auto guide = make_guide(Kind::shapes, 60, 40, 3);
    for (const Thrown what : {Thrown::error, Thrown::memory, Thrown::number}) {
        Mesh mesh;
        std::string error;
        const auto progress = [&](float) {
            throw_it(what);
            return true;
        };
        EXPECT_FALSE(build_mesh(guide.data(), 60, 40, {}, mesh, nullptr, &error, progress));
        expect_line(error);
        EXPECT_FALSE(build_mesh(guide.data(), 60, 40, {}, mesh, nullptr, nullptr, progress));
    }
}

TEST(Throwing, NorDoWhatIsDoneWithPoints) {
    constexpr int side = 60;
    const auto guide = make_guide(Kind::noise, side, side, 3);
    PointMesh mesh;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            mesh.x.push_back(x);
            mesh.y.push_back(y);
        }
    ASSERT_TRUE(delaunay(mesh));
    std::vector<uint8_t> missing(guide.size());
    for (int y = 12; y < 48; ++y)
        std::fill_n(&missing[size_t(side * y + 12)], 36, uint8_t(1));
    // At first edges flip; later on, in holes, other threads wait for the one that tells.
    for (const float from : {0.0f, 0.5f})
        for (const Thrown what : {Thrown::error, Thrown::memory, Thrown::number}) {
            const auto progress = [&](float share) {
                if (share >= from)
                    throw_it(what);
                return true;
            };
            std::string error;
            std::vector<float> values = guide;
            EXPECT_FALSE(fill_holes(values.data(), side, side, 1, nullptr, guide.data(),
                                    missing.data(), {}, &error, progress));
            expect_line(error);
            if (from > 0)
                continue;
            const auto before = mesh.triangles;
            EXPECT_FALSE(optimise(mesh, guide.data(), {}, nullptr, &error, progress));
            expect_line(error);
            EXPECT_FALSE(delaunay(mesh, &error, progress));
            expect_line(error);
            EXPECT_EQ(mesh.triangles, before);
        }
}

} // namespace
} // namespace ddt::test
