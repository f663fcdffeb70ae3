// SPDX-License-Identifier: Apache-2.0
// A tile's rows, shared by threads that have no tile of their own.
#include "core/tiles/work_on_cpu.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "core/tiles/crew_size.h"
#include "core/tiles/rows_left.h"
#include "tests/core/gathering.h"
#include "tests/core/job_helpers.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

constexpr int threads = 4;

TEST(RowsLeft, AreTakenFromTheTopAndGivenFromTheBottom) {
    MeshedTile tile;
    RowsLeft rows, others;
    rows.begin(tile, {10, 100, 30, 200}, true, 20);
    const Rect first = rows.take(30);
    EXPECT_EQ(first.y0, 100);
    EXPECT_EQ(first.y1, 130);
    EXPECT_EQ(rows.to_share(), 70);
    ASSERT_TRUE(rows.give(others));
    EXPECT_EQ(&others.of(), &tile);
    EXPECT_TRUE(others.grid());
    const Rect given = others.take(1000), kept = rows.take(1000);
    EXPECT_EQ(kept.y0, 130);
    EXPECT_EQ(kept.y1, 165);
    EXPECT_EQ(given.y0, 165);
    EXPECT_EQ(given.y1, 200);
    EXPECT_EQ(given.x0, 10);
    EXPECT_EQ(given.x1, 30);
    EXPECT_TRUE(rows.take(1).empty());
    EXPECT_FALSE(rows.give(others));
}

TEST(RowsLeft, AreNotGivenWhereThatIsNotWorthIt) {
    MeshedTile tile;
    RowsLeft rows, others;
    rows.begin(tile, {0, 0, 5, 39}, true, 20);
    EXPECT_EQ(rows.to_share(), 0);
    EXPECT_FALSE(rows.give(others));
    rows.begin(tile, {0, 0, 5, 40}, true, 20);
    EXPECT_EQ(rows.to_share(), 40);
    rows.begin(tile, {0, 0, 5, 40}, true, 0);
    EXPECT_EQ(rows.to_share(), 0);
}

/// Keeps those that write until so many do at once, or for a minute.
class Meeting final : public Sink {
public:
    Meeting(const Rect& out, int channels, int wanted) : writing(wanted), m_sink(out, channels) {}
    bool write(const Rect& r, float* values) override {
        const Gathering::Guest here(writing);
        return (!at_meeting || at_meeting()) && m_sink.write(r, values);
    }
    const TestSink& sink() const { return m_sink; }

    Gathering writing;
    std::function<bool()> at_meeting; ///< called by each afterwards; its answer is write()'s

private:
    TestSink m_sink;
};

struct OneTile {
    explicit OneTile(int n = 3) : source({-7, 11, 173, 191}, n, 31), channels(n) {}

    Job job(const char* filter) const {
        Job made = job_of(source, channels, threads);
        set_filter(filter, made);
        made.device = Device::cpu;
        return made;
    }
    std::vector<float> by_one_thread(Job job) {
        job.threads = 1;
        TestSink sink(out, channels);
        EXPECT_EQ(enlarge(source, sink, mapping(), job), Outcome::done);
        return sink.values();
    }
    ResizeMapping mapping() const { return mapping_of(source.window(), out, out); }

    const ManyThreads allowed;
    TestSource source;
    int channels;
    Rect out{0, 0, 721, 719};
};

TEST(WorkOnCpu, AllThreadsWriteOneTileAndTheBitsAreThoseOfOne) {
    for (const char* filter :
         {"ddt", "ddt-linear", "ddt-sharp", "ddt-sharp,clipped=1", "ddt-sharp,meshes=2"})
        for (const int channels : {1, 3, 5}) {
            SCOPED_TRACE(::testing::Message() << filter << ", " << channels);
            OneTile tile(channels);
            const Job job = tile.job(filter);
            Meeting sink(tile.out, channels, threads);
            ASSERT_EQ(enlarge(tile.source, sink, tile.mapping(), job), Outcome::done);
            EXPECT_EQ(sink.writing.most(), threads);
            EXPECT_EQ(sink.sink().written(1), int64_t(tile.out.area()));
            EXPECT_EQ(differing(sink.sink().values(), tile.by_one_thread(job)), 0u);
        }
}

TEST(WorkOnCpu, IdsAreSharedToo) {
    OneTile tile(2);
    Job job = tile.job("ddt");
    job.kinds = {Channel::blend, Channel::nearest};
    Meeting sink(tile.out, 2, threads);
    ASSERT_EQ(enlarge(tile.source, sink, tile.mapping(), job), Outcome::done);
    EXPECT_EQ(sink.writing.most(), threads);
    EXPECT_EQ(differing(sink.sink().values(), tile.by_one_thread(job)), 0u);
}

TEST(WorkOnCpu, PositionsInAnyOrderAreSharedToo) {
    for (const char* filter : {"ddt", "ddt-sharp", "ddt-sharp,clipped=1", "ddt,meshes=2"})
        for (const int channels : {3, 5}) {
            SCOPED_TRACE(::testing::Message() << filter << ", " << channels);
            OneTile tile(channels);
            const Job job = tile.job(filter);
            Meeting sink(tile.out, channels, threads);
            const ResizeMapping mapping = tile.mapping();
            ASSERT_EQ(enlarge(tile.source, sink, Opaque(mapping), job), Outcome::done);
            EXPECT_EQ(sink.writing.most(), threads);
            EXPECT_EQ(sink.sink().written(1), int64_t(tile.out.area()));
            EXPECT_EQ(differing(sink.sink().values(), tile.by_one_thread(job)), 0u);
        }
}

TEST(WorkOnCpu, ATileIsDoneWhenTheLastPartIs) {
    OneTile tile;
    Job job = tile.job("ddt");
    std::vector<float> told;
    job.progress = [&](float share) {
        told.push_back(share);
        return true;
    };
    Meeting sink(tile.out, 3, threads);
    ASSERT_EQ(enlarge(tile.source, sink, tile.mapping(), job), Outcome::done);
    EXPECT_EQ(told, std::vector<float>{1.0f});
}

/// Counts what it is given.
class Counting final : public Sink {
public:
    bool write(const Rect& r, float*) override {
        numbers += int64_t(r.area());
        return true;
    }
    std::atomic<int64_t> numbers{0}; ///< of one channel
};

/// A result so large that its tiles are written for long.
struct LargeResult {
    LargeResult(Rect window, int width, int height, int workers = threads)
        : source(window, 1, 37), out{0, 0, width, height}, job(job_of(source, 1, workers)) {
        set_filter("ddt", job);
        job.device = Device::cpu;
    }
    Outcome enlarge_to(Sink& sink, bool grid = true) {
        const ResizeMapping mapping = mapping_of(source.window(), out, out);
        const Opaque opaque(mapping);
        return enlarge(source, sink, grid ? static_cast<const Mapping&>(mapping) : opaque, job);
    }

    const ManyThreads allowed;
    TestSource source;
    Rect out;
    Job job;
};

/// Of one tile, nearly six times told_numbers: as a grid, the same in three panels, and in bands.
void in_each_way(const std::function<void(LargeResult& large, bool grid)>& test) {
    for (const bool panels : {false, true})
        for (const bool grid : {true, false})
            for (const int workers : {1, threads}) {
                SCOPED_TRACE(::testing::Message() << panels << grid << workers);
                const Rect window{0, 0, 200, panels ? 8 : 200};
                LargeResult large(window, panels ? 3 << 14 : 5000, panels ? 500 : 5000, workers);
                test(large, grid);
            }
}

TEST(WorkOnCpu, ProgressIsToldOfPartsOfALargeTile) {
    in_each_way([](LargeResult& large, bool grid) {
        std::vector<float> told;
        large.job.progress = [&](float share) {
            told.push_back(share);
            return true;
        };
        Counting sink;
        ASSERT_EQ(large.enlarge_to(sink, grid), Outcome::done);
        EXPECT_EQ(sink.numbers, int64_t(large.out.area()));
        EXPECT_GE(told.size(), 4u);
        EXPECT_LE(int64_t(told.size()), int64_t(large.out.area()) / told_numbers + 1);
        EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
        EXPECT_EQ(std::count(told.begin(), told.end(), 1.0f), 1);
        EXPECT_EQ(told.back(), 1.0f);
        const double first = double(told_numbers) / double(large.out.area());
        EXPECT_NEAR(told.front(), first, large.job.threads == 1 ? 0.02 : first);
    });
}

TEST(WorkOnCpu, ALargeTileEndsWhenProgressSaysSo) {
    in_each_way([](LargeResult& large, bool grid) {
        int calls = 0;
        int64_t written = 0;
        Counting sink;
        large.job.progress = [&](float) {
            ++calls;
            written = sink.numbers;
            return false;
        };
        EXPECT_EQ(large.enlarge_to(sink, grid), Outcome::cancelled);
        EXPECT_EQ(calls, 1);
        EXPECT_LT(sink.numbers, int64_t(large.out.area()));
        if (large.job.threads == 1) {
            EXPECT_EQ(sink.numbers, written);
        }
    });
}

TEST(WorkOnCpu, WhatProgressThrowsInALargeTileEndsTheWork) {
    LargeResult large({0, 0, 200, 200}, 5000, 5000);
    int calls = 0;
    large.job.progress = [&](float) -> bool {
        ++calls;
        throw std::runtime_error("no more");
    };
    Counting sink;
    EXPECT_EQ(large.enlarge_to(sink), Outcome::bad_job);
    EXPECT_EQ(calls, 1);
}

/// Four tiles at once, each of them told in parts, and a share that is filled before.
TEST(WorkOnCpu, ProgressOfSeveralLargeTilesNeverFalls) {
    for (const Holes holes : {Holes::keep, Holes::fill}) {
        LargeResult large({0, 0, 400, 300}, 6000, 4500);
        large.job.holes = holes;
        std::vector<float> told;
        large.job.progress = [&](float share) {
            told.push_back(share);
            return true;
        };
        Counting sink;
        ASSERT_EQ(large.enlarge_to(sink), Outcome::done);
        EXPECT_GT(told.size(), 5u);
        EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
        EXPECT_EQ(std::count(told.begin(), told.end(), 1.0f), 1);
    }
}

/// Shows the source's first pixel and nothing else.
class FirstPixel final : public Mapping {
public:
    explicit FirstPixel(const Rect& out) : m_out(out) {}
    Rect reach(double, double, double, double) const override { return m_out; }
    void row(int, int x0, int x1, Position* positions, uint8_t* inside) const override {
        std::fill(positions, positions + (x1 - x0), Position{});
        std::fill(inside, inside + (x1 - x0), uint8_t(1));
    }

private:
    Rect m_out;
};

TEST(WorkOnCpu, ProgressIsToldOfResultsOfMoreNumbersThanAnIntegerHolds) {
    constexpr int channels = 1 << 14;
    TestSource source({0, 0, 2, 2}, channels, 1);
    const FirstPixel mapping({-(1 << 29), 0, 1 << 29, 1 << 19}); // 2^63 numbers
    Job job = job_of(source, channels, 1);
    set_filter("ddt", job);
    job.device = Device::cpu;
    int told = 0;
    job.progress = [&](float) { return ++told < 2; };
    class Sparing final : public Sink {
        int64_t m_numbers = 0;
        bool write(const Rect& r, float*) override {
            m_numbers += int64_t(r.area()) * channels;
            return m_numbers < 4 * told_numbers;
        }
    } sink;
    EXPECT_EQ(enlarge(source, sink, mapping, job), Outcome::cancelled);
    EXPECT_EQ(told, 2);
}

TEST(JobState, SharesNeitherFallNorReachOneBeforeTheEnd) {
    constexpr int tiles = 5000;
    Job job;
    std::vector<float> told;
    job.progress = [&](float share) {
        told.push_back(share);
        return true;
    };
    JobState state(job, tiles);
    for (int tile = 1; tile < tiles; ++tile)
        state.tile_done(tile);
    for (int i = 0; i < 100; ++i)
        state.wrote(told_numbers, 100 * told_numbers, 0);
    EXPECT_EQ(told.size(), size_t(tiles) - 1 + 100);
    EXPECT_LT(told.back(), 1.0f);
    state.tile_done(0);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(std::count(told.begin(), told.end(), 1.0f), 1);
}

// Others may have reported all of a tile before it is done, or all but a number.
TEST(JobState, OneIsToldOnceWhoeverEndsLast) {
    for (const int64_t lacking : {0, 1}) {
        std::vector<float> told;
        Job job;
        job.progress = [&](float share) {
            told.push_back(share);
            return true;
        };
        JobState state(job, 2);
        for (const int tile : {0, 1})
            state.wrote(64 * told_numbers - lacking, 64 * told_numbers, tile);
        for (const int tile : {0, 1})
            state.tile_done(tile);
        EXPECT_EQ(std::count(told.begin(), told.end(), 1.0f), 1);
        EXPECT_EQ(told.back(), 1.0f);
    }
}

TEST(WorkOnCpu, WhatFailsWhileTheyShareEndsTheWork) {
    OneTile tile;
    const Job job = tile.job("ddt");
    {
        Meeting sink(tile.out, 3, threads);
        std::atomic<int> calls{0};
        sink.at_meeting = [&] { return ++calls != 2; };
        EXPECT_EQ(enlarge(tile.source, sink, tile.mapping(), job), Outcome::sink_failed);
    }
    Meeting sink(tile.out, 3, threads);
    std::atomic<int> calls{0};
    sink.at_meeting = [&]() -> bool {
        if (++calls == 2)
            throw std::runtime_error("the disk fell down");
        return true;
    };
    std::string error;
    EXPECT_EQ(enlarge(tile.source, sink, tile.mapping(), job, &error), Outcome::bad_job);
    EXPECT_NE(error.find("the disk fell down"), std::string::npos) << error;
}

// What a sink that failed is handed afterwards is what others had in hand.
TEST(WorkOnCpu, NobodyGoesOnForLongOnceTheSinkHasFailed) {
    class Failing final : public Sink {
    public:
        bool write(const Rect& r, float*) override {
            if (m_failed)
                after += int64_t(r.area());
            else if (++m_calls == 20)
                m_failed = true;
            return !m_failed;
        }
        std::atomic<int64_t> after{0};

    private:
        std::atomic<bool> m_failed{false};
        std::atomic<int> m_calls{0};
    };
    OneTile tile(1);
    Job job = tile.job("ddt");
    job.threads = 2;
    for (const bool grid : {true, false}) {
        Failing sink;
        const Rect to{0, 0, 16 * tile.source.window().width(), 16 * tile.source.window().height()};
        const ResizeMapping mapping = mapping_of(tile.source.window(), to, to);
        const Opaque opaque(mapping);
        EXPECT_EQ(
            enlarge(tile.source, sink, grid ? static_cast<const Mapping&>(mapping) : opaque, job),
            Outcome::sink_failed);
        EXPECT_LT(sink.after, int64_t(to.area() / 4)) << grid;
    }
}

TEST(WorkOnCpu, TilesWaitForAPlaceAndTheBitsAreThoseOfOne) {
    // So many channels that eight threads have places for fewer tiles than there are.
    constexpr int channels = 64, many = 8;
    const ManyThreads allowed(many);
    TestSource source({0, 0, 400, 400}, channels, 41);
    const Rect out{0, 0, 728, 728};
    const ResizeMapping mapping = mapping_of(source.window(), out, out);
    Job job = job_of(source, channels, many);
    set_filter("ddt", job);
    job.device = Device::cpu;
    const Grid grid(job.window);
    const CrewSize size = crew_size(mapping, job, grid, many);
    ASSERT_EQ(size.members, size_t(many));
    ASSERT_LT(size.places, size_t(grid.count()));
    TestSink sink(out, channels), by_one(out, channels);
    ASSERT_EQ(enlarge(source, sink, mapping, job), Outcome::done);
    EXPECT_LE(size_t(source.most_running), size.places);
    EXPECT_EQ(sink.written(1), int64_t(out.area()));
    job.threads = 1;
    ASSERT_EQ(enlarge(source, by_one, mapping, job), Outcome::done);
    EXPECT_EQ(differing(sink.values(), by_one.values()), 0u);
}

/// Every other thread that asks is said to be near the second of two nodes.
int some_node() {
    static std::atomic<int> asked{0};
    thread_local const int node = asked++ % 2;
    return node;
}

/// Remembers which node's threads read which tile of a column of them.
class NodesSource final : public TestSource {
public:
    explicit NodesSource(int tiles_)
        : TestSource({0, 0, 8, tiles_ * tile_size + 1}, 1, 3), nodes(size_t(tiles_), -1) {}
    bool read(const Rect& r, float* values, float* guide) override {
        const int tile = (r.y0 + tile_halo) / tile_size;
        nodes[size_t(tile)] = some_node();
        return TestSource::read(r, values, guide);
    }
    std::vector<int> nodes; ///< a tile
};

TEST(WorkOnCpu, NodesOfMemoryHaveNeighbouringTiles) {
    constexpr int tiles = 96;
    const ManyThreads allowed;
    NodesSource source(tiles);
    const Rect out{0, 0, 32, 4 * source.window().height()};
    const Job job = job_of(source, 1, threads);
    const ResizeMapping mapping = mapping_of(source.window(), out, out);
    const Grid grid(job.window);
    ASSERT_EQ(grid.count(), tiles);
    ddt::JobState state(job, tiles);
    Statistics statistics;
    TestSink sink(out, 1), by_one(out, 1);
    work_on_cpu({source, sink, mapping, job, grid, threads}, state, statistics, some_node);
    ASSERT_EQ(state.outcome(), Outcome::done);
    EXPECT_EQ(sink.written(1), int64_t(out.area()));
    // However unlike their paces: when one has nothing left, what the other has is halved, which
    // can happen seven times before it is one tile, and each time two runs of tiles more begin at
    // most.
    EXPECT_EQ(std::count(source.nodes.begin(), source.nodes.end(), -1), 0);
    int runs = 1;
    for (size_t i = 1; i < tiles; ++i)
        runs += source.nodes[i] != source.nodes[i - 1];
    EXPECT_LE(runs, 1 + 2 * 7);

    Job alone = job;
    alone.threads = 1;
    ASSERT_EQ(enlarge(source, by_one, mapping, alone), Outcome::done);
    EXPECT_EQ(differing(sink.values(), by_one.values()), 0u);
}

TEST(WorkOnCpu, SmallResultsAreOneThreads) {
    const ManyThreads allowed;
    TestSource source({0, 0, 64, 64}, 1, 5);
    const Rect out{0, 0, 255, 255};
    Meeting sink(out, 1, 1);
    const Job job = job_of(source, 1, threads);
    ASSERT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out), job), Outcome::done);
    EXPECT_EQ(sink.writing.most(), 1);
}

} // namespace
} // namespace ddt::test
