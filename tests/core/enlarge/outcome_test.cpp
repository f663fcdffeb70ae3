// SPDX-License-Identifier: Apache-2.0
// How work ends, and what is told of it: progress, statistics, failures.
#include <chrono>
#include <limits>
#include <new>
#include <stdexcept>

#include "ddt/core.h"
#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"
#include "tests/environment.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

TEST(Outcomes, NothingWantedIsNothingDone) {
    TestSource source({0, 0, 20, 20}, 1, 13);
    const Rect to{0, 0, 40, 40}, out{7, 7, 7, 20};
    TestSink sink(to, 1);
    const auto mapping = mapping_of(source.window(), to, out);
    EXPECT_EQ(enlarge(source, sink, mapping, job_of(source, 1)), Outcome::done);
    EXPECT_EQ(sink.writes, 0);
    EXPECT_TRUE(source.reads.empty());
}

TEST(Outcomes, StatisticsAreSumsOverTheTiles) {
    TestSource source({0, 0, 300, 100}, 1, 15);
    const Rect out{0, 0, 300, 100};
    const auto mapping = mapping_of(source.window(), out, out);
    Statistics one, two;
    two.flips = 12345; // what is in it is overwritten
    Job job = job_of(source, 1);
    job.statistics = &one;
    run(source, job, mapping, out);
    int64_t pixels = 0;
    for (const Rect& r : source.reads)
        pixels += int64_t(r.area());
    EXPECT_EQ(source.reads.size(), 2u);
    EXPECT_EQ(one.pixels, pixels);
    EXPECT_GT(one.flips, 1000);
    EXPECT_GT(one.evaluations, 2 * pixels);
    EXPECT_GT(one.iterations, 2);
    EXPECT_EQ(one.device, Device::cpu);
    EXPECT_LE(one.iterations, 64);
    job.statistics = &two;
    job.threads = 4;
    run(source, job, mapping, out);
    EXPECT_EQ(two.pixels, one.pixels);
    EXPECT_EQ(two.flips, one.flips);
    EXPECT_EQ(two.evaluations, one.evaluations);
    EXPECT_EQ(two.iterations, one.iterations);
}

/// Counts the nanoseconds that it takes, which are some: it waits for the clock to go on.
class Wait {
public:
    void operator()() {
        const auto begin = Clock::now();
        while (Clock::now() == begin) {
        }
        spent += since(begin);
    }
    static int64_t since(std::chrono::steady_clock::time_point begin) {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin).count();
    }
    using Clock = std::chrono::steady_clock;
    int64_t spent = 0;
};

class SlowSource final : public TestSource {
public:
    using TestSource::TestSource;
    bool read(const Rect& r, float* values, float* guide) override {
        wait();
        return TestSource::read(r, values, guide);
    }
    Wait wait;
};

class SlowSink final : public TestSink {
public:
    using TestSink::TestSink;
    bool write(const Rect& r, float* values) override {
        wait();
        return TestSink::write(r, values);
    }
    Wait wait;
};

TEST(Outcomes, TimesAreThoseOfTheirStages) {
    SlowSource source({0, 0, 60, 50}, 1, 15);
    const Rect out{0, 0, 60, 50};
    SlowSink sink(out, 1);
    Statistics statistics;
    Job job = job_of(source, 1);
    job.statistics = &statistics;
    const auto begin = Wait::Clock::now();
    ASSERT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out), job), Outcome::done);
    const int64_t all = Wait::since(begin);
    const StageTimes& t = statistics.times;
    EXPECT_GE(t.read, source.wait.spent);
    EXPECT_GE(t.write, sink.wait.spent);
    // Of one thread, each moment once.
    EXPECT_LE(t.read + t.triangulate + t.surface + t.sample + t.write, all);
}

TEST(Outcomes, StatisticsOfWorkThatDidNotBeginAreOfNone) {
    TestSource source({0, 0, 60, 50}, 1, 15);
    source.values()[1000] = std::nanf("");
    const Rect out{0, 0, 60, 50};
    Statistics statistics;
    statistics.pixels = -5;
    Job job = job_of(source, 1);
    job.holes = Holes::fill;
    job.statistics = &statistics;
    job.progress = [](float) { return false; };
    TestSink sink(out, 1);
    EXPECT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out), job),
              Outcome::cancelled);
    EXPECT_EQ(statistics.pixels, 0);
}

TEST(Outcomes, ADeviceThatCannotBeHadEndsTheWorkBeforeAnythingIsRead) {
    const Environment device("DDT_DEVICE", "no such");
    TestSource source({0, 0, 60, 50}, 1, 15);
    const Rect out{0, 0, 120, 100};
    TestSink sink(out, 1);
    for (const Holes holes : {Holes::keep, Holes::fill}) {
        Job job = job_of(source, 1);
        job.device = Device::automatic;
        job.holes = holes;
        std::string error;
        EXPECT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out), job, &error),
                  Outcome::device_unavailable);
        EXPECT_NE(error.find("no such"), std::string::npos) << error;
    }
    EXPECT_TRUE(source.reads.empty());
    EXPECT_EQ(sink.writes, 0);
}

TEST(Outcomes, ProgressRisesToOneAndIsNeverCalledTwiceAtOnce) {
    TestSource source({0, 0, 600, 530}, 1, 16, Kind::flat);
    const Rect out{0, 0, 600, 530};
    const ManyThreads allowed;
    for (const int threads : {1, 4}) {
        Job job = job_of(source, 1, threads);
        std::vector<float> shares;
        std::atomic<int> inside{0};
        job.progress = [&](float share) {
            EXPECT_EQ(++inside, 1);
            shares.push_back(share);
            --inside;
            return true;
        };
        run(source, job, mapping_of(source.window(), out, out), out);
        ASSERT_EQ(shares.size(), 9u);
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_GT(shares.front(), 0.0f);
        EXPECT_EQ(shares.back(), 1.0f);
    }
}

TEST(Outcomes, ProgressIsOneAtTheEndAlsoWhereNothingIsWanted) {
    TestSource source({0, 0, 300, 20}, 1, 13); // of a single tile its end is told all the same
    const Rect to{0, 0, 600, 40};
    TestSink sink(to, 1);
    const auto nothing = mapping_of(source.window(), to, {7, 7, 7, 20});
    for (const Holes holes : {Holes::keep, Holes::fill}) {
        Job job = job_of(source, 1);
        job.holes = holes;
        std::vector<float> shares;
        job.progress = [&](float share) {
            shares.push_back(share);
            return share < 1;
        };
        EXPECT_EQ(enlarge(source, sink, nothing, job), Outcome::cancelled);
        ASSERT_FALSE(shares.empty());
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_EQ(shares.back(), 1.0f);
        job.progress = [](float) { return true; };
        EXPECT_EQ(enlarge(source, sink, nothing, job), Outcome::done);
    }
    EXPECT_EQ(sink.writes, 0);
}

TEST(Outcomes, ProgressCanCancel) {
    TestSource source({0, 0, 600, 530}, 1, 17, Kind::flat);
    const Rect out{0, 0, 600, 530};
    const ManyThreads allowed;
    for (const int threads : {1, 3}) {
        source.reads.clear();
        Job job = job_of(source, 1, threads);
        int calls = 0;
        job.progress = [&](float) { return ++calls < 2; };
        TestSink sink(out, 1);
        std::string error;
        const auto mapping = mapping_of(source.window(), out, out);
        EXPECT_EQ(enlarge(source, sink, mapping, job, &error), Outcome::cancelled);
        EXPECT_EQ(error, "ddt: cancelled");
        EXPECT_EQ(calls, 2);
        // Those in flight may end, no more begin.
        EXPECT_LE(source.reads.size(), size_t(1 + 2 * threads));
        EXPECT_GT(sink.written(0), 0);
    }
}

/// A source or sink that fails, by returning false or by throwing, after some calls.
enum class Failure { none, returns, throws_memory, throws };
struct FailingSource final : TestSource {
    using TestSource::TestSource;
    Failure failure = Failure::returns;
    int good = 0; ///< calls that go well
    bool read(const Rect& r, float* values, float* guide) override {
        if (int(reads.size()) < good || failure == Failure::none)
            return TestSource::read(r, values, guide);
        if (failure == Failure::throws_memory)
            throw std::bad_alloc();
        if (failure == Failure::throws)
            throw std::runtime_error("no such reel");
        return false;
    }
};
struct FailingSink final : TestSink {
    using TestSink::TestSink;
    bool write(const Rect& r, float* values) override {
        return writes < 1 && TestSink::write(r, values);
    }
};

TEST(Outcomes, AFailingSourceOrSinkEndsTheWork) {
    const Rect window{0, 0, 600, 530};
    const auto mapping = mapping_of(window, window, window);
    const ManyThreads allowed;
    for (const int threads : {1, 3}) {
        std::string error;
        FailingSource source(window, 1, 18, Kind::flat);
        const auto outcome = [&](Failure failure, int good) {
            source.failure = failure;
            source.reads.clear();
            source.good = good;
            TestSink sink(window, 1);
            return enlarge(source, sink, mapping, job_of(source, 1, threads), &error);
        };
        EXPECT_EQ(outcome(Failure::returns, 0), Outcome::source_failed);
        EXPECT_EQ(error, "ddt: the source could not be read");
        EXPECT_EQ(outcome(Failure::returns, 3), Outcome::source_failed);
        EXPECT_EQ(outcome(Failure::throws_memory, 0), Outcome::out_of_memory);
        EXPECT_EQ(error, "ddt: out of memory");
        EXPECT_EQ(outcome(Failure::throws, 0), Outcome::bad_job);
        EXPECT_EQ(error, "ddt: no such reel");
        EXPECT_EQ(outcome(Failure::none, 0), Outcome::done);
        EXPECT_EQ(error, "");

        source.reads.clear();
        FailingSink sink(window, 1);
        EXPECT_EQ(enlarge(source, sink, mapping, job_of(source, 1, threads), &error),
                  Outcome::sink_failed);
        EXPECT_EQ(error, "ddt: the result could not be written");
        EXPECT_LE(source.reads.size(), size_t(1 + threads));
    }
}

// To be kept whole, where holes are filled.
TEST(Outcomes, ASizeThatNoVectorCanHaveIsOutOfMemory) {
    TestSource source({0, 0, 8, 8}, 1, 19);
    const Rect window{0, 0, 46340, 46340};
    Job job = job_of(source, std::numeric_limits<int>::max());
    job.window = window;
    job.holes = Holes::fill;
    TestSink sink({0, 0, 8, 8}, 1);
    std::string error;
    EXPECT_EQ(enlarge(source, sink, mapping_of(window, window, {0, 0, 8, 8}), job, &error),
              Outcome::out_of_memory);
    EXPECT_EQ(error, "ddt: out of memory");
    EXPECT_TRUE(source.reads.empty());
}

TEST(Outcomes, BadJobsAreToldFromGoodOnes) {
    TestSource source({0, 0, 8, 8}, 2, 19);
    const Rect out{0, 0, 16, 16};
    const auto mapping = mapping_of(source.window(), out, out);
    const auto outcome = [&](auto&& change, const char* word) {
        Job job = job_of(source, 2);
        change(job);
        TestSink sink(out, 2);
        std::string error;
        const Outcome o = enlarge(source, sink, mapping, job, &error);
        EXPECT_EQ(o == Outcome::done, error.empty());
        EXPECT_NE(error.find(word), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
        EXPECT_EQ(enlarge(source, sink, mapping, job, nullptr), o);
        return o;
    };
    constexpr int far = largest_coordinate;
    EXPECT_EQ(outcome([](Job&) {}, ""), Outcome::done);
    EXPECT_EQ(outcome([](Job& j) { j.mesh.max_iterations = 0; }, ""), Outcome::done);
    EXPECT_EQ(outcome([](Job& j) { j.mesh.max_iterations = most_iterations; }, ""), Outcome::done);
    EXPECT_EQ(outcome([](Job& j) { j.window = {0, 0, 0, 8}; }, "window"), Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.window = {0, 9, 8, 8}; }, "window"), Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.window.x1 = far + 1; }, "window"), Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.window.y0 = -far - 1; }, "window"), Outcome::bad_job);
    EXPECT_EQ(outcome(
                  [](Job& j) {
                      j.window = {-far, -far, far, far};
                  },
                  "window"),
              Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.channels = 0; }, "channel"), Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.kinds.resize(1); }, "kinds"), Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.kinds.resize(3); }, "kinds"), Outcome::bad_job);
    EXPECT_EQ(outcome(
                  [](Job& j) {
                      j.kinds = {Channel::blend, Channel(3)};
                  },
                  "kinds"),
              Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.surface.kind = Surface(2); }, "kind"), Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.mesh.max_iterations = -1; }, "iterations="), Outcome::bad_job);
    EXPECT_EQ(outcome([](Job& j) { j.mesh.max_iterations = most_iterations + 1; }, "iterations="),
              Outcome::bad_job);
}

TEST(Outcomes, ResultsLieWithinTheCoordinatesToo) {
    TestSource source({0, 0, 8, 8}, 1, 19);
    constexpr int far = largest_coordinate;
    TestSink sink({0, 0, 16, 16}, 1);
    const auto outcome = [&](Rect to, Rect out) {
        std::string error;
        const Outcome o =
            enlarge(source, sink, mapping_of(source.window(), to, out), job_of(source, 1), &error);
        EXPECT_EQ(o == Outcome::done, error.find("output's coordinates") == error.npos) << error;
        return o;
    };
    EXPECT_EQ(outcome({0, 0, 2147483647, 16}, {2147443647, 0, 2147483647, 1}), Outcome::bad_job);
    EXPECT_EQ(outcome({0, 0, 16, 2147483647}, {0, far, 16, far + 1}), Outcome::bad_job);
    EXPECT_EQ(outcome({-far - 1, 0, 16, 16}, {-far - 1, 0, 1 - far, 1}), Outcome::bad_job);
    EXPECT_EQ(sink.writes, 0);
    EXPECT_EQ(outcome({0, 0, 16, far}, {0, far - 2, 16, far}), Outcome::done);
}

} // namespace
} // namespace ddt::test
