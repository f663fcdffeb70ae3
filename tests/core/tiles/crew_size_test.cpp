// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/crew_size.h"

#include "core/tiles/tile_memory.h"
#include "core/tiles/tile_worker.h"
#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

constexpr const char* filters[] = {"ddt", "ddt-linear", "ddt-sharp", "ddt-sharp,clipped=1"};
constexpr size_t mib = size_t(1) << 20;

struct Large {
    explicit Large(const char* filter, int channels) {
        job.window = {0, 0, 16384, 8192};
        job.channels = channels;
        set_filter(filter, job);
    }
    ResizeMapping mapping() const { return mapping_of(job.window, to, to); }
    CrewSize of(size_t threads) const {
        return crew_size(mapping(), job, Grid(job.window), threads);
    }
    size_t bytes(CrewSize size) const {
        return size.members * TileWorker::memory(job, mapping()) +
               size.places * TileMemory::needed(job);
    }

    Job job;
    Rect to{0, 0, 32768, 16384};
};

/// As ddt/job.h says.
size_t limit(size_t threads) {
    return 200 * mib + (std::max<size_t>(threads, 40) - 40) * 6 * mib;
}

TEST(CrewSize, AllThreadsWorkWithinTheirMemory) {
    for (const char* filter : filters)
        for (const int channels : {1, 3, 4}) {
            const Large large(filter, channels);
            for (const size_t threads : {1, 16, 33, 40, 64, 128, 1000}) {
                SCOPED_TRACE(::testing::Message() << filter << ", " << channels << ", " << threads);
                const CrewSize size = large.of(threads);
                EXPECT_EQ(size.members, threads);
                EXPECT_LE(size.places, threads);
                EXPECT_GE(5 * size.places, threads);
                EXPECT_LE(large.bytes(size), limit(threads));
                // One more would be too many.
                if (size.places < threads) {
                    EXPECT_GT(large.bytes({threads, size.places + 1}), limit(threads));
                }
            }
        }
}

TEST(CrewSize, AllThreadsWorkAtEightTimesTheSizeAndNineTenthsAtSixteen) {
    for (const int scale : {8, 16})
        for (const char* filter : filters)
            for (const int channels : {1, 3, 4}) {
                Large large(filter, channels);
                large.to = {0, 0, 16384 * scale, 8192 * scale};
                for (const size_t threads : {16, 40, 128}) {
                    SCOPED_TRACE(::testing::Message()
                                 << scale << ", " << filter << ", " << channels << ", " << threads);
                    const CrewSize size = large.of(threads);
                    EXPECT_GE(size.members, scale == 8 ? threads : threads - threads / 10);
                    EXPECT_LE(large.bytes(size), limit(threads));
                }
            }
}

TEST(CrewSize, AllThreadsWorkOnTenChannelsOfPlainFiltersAndOnTwelveAtFourTimesTheSize) {
    struct Case {
        int channels, scale;
    };
    for (const char* filter : {"ddt", "ddt-linear"})
        for (const Case& c : {Case{10, 8}, Case{12, 4}}) {
            Large large(filter, c.channels);
            large.to = {0, 0, 16384 * c.scale, 8192 * c.scale};
            for (size_t threads = 1; threads <= 200; ++threads) {
                SCOPED_TRACE(::testing::Message()
                             << filter << ", " << c.channels << ", " << threads);
                const CrewSize size = large.of(threads);
                EXPECT_EQ(size.members, threads);
                EXPECT_LE(large.bytes(size), limit(threads));
            }
        }
}

TEST(CrewSize, AFewThreadsHaveATileEach) {
    for (const char* filter : filters)
        EXPECT_EQ(Large(filter, 4).of(16).places, 16u) << filter;
}

TEST(CrewSize, ThreadsDoNotShareTilesOfManyChannelsThatAreCorrected) {
    for (const int channels : {5, 16, 32, 64})
        for (const size_t threads : {2, 8, 16, 40, 128}) {
            SCOPED_TRACE(::testing::Message() << channels << ", " << threads);
            const Large large("ddt-sharp", channels);
            const CrewSize size = large.of(threads);
            EXPECT_EQ(size.places, size.members);
            EXPECT_LE(large.bytes(size), limit(threads));
            if (size.members < threads) {
                EXPECT_GT(large.bytes({size.members + 1, size.places + 1}), limit(threads));
            }
        }
    EXPECT_EQ(Large("ddt-sharp", 16).of(16).members, 8u);
    EXPECT_EQ(Large("ddt-sharp", 32).of(16).members, 5u);
    // Others' parts take little more than the whole.
    for (const char* filter : {"ddt", "ddt-sharp,clipped=1"}) {
        const CrewSize size = Large(filter, 32).of(16);
        EXPECT_GT(size.members, size.places) << filter;
    }
}

TEST(CrewSize, ThreadsShareTilesWhereThereAreFewerThanThreads) {
    Large two("ddt-sharp", 16);
    two.job.window = {0, 0, 600, 300};
    two.to = {0, 0, 2400, 1200};
    const CrewSize size = two.of(8);
    EXPECT_EQ(size.places, size_t(Grid(two.job.window).count()));
    EXPECT_EQ(size.members, 8u);
}

TEST(CrewSize, PositionsInAnyOrderTakeNoMore) {
    for (const char* filter : filters)
        for (const int channels : {1, 3, 4}) {
            const Large large(filter, channels);
            const ResizeMapping mapping = large.mapping();
            const Opaque opaque(mapping);
            for (const size_t threads : {16, 40, 64, 128}) {
                SCOPED_TRACE(::testing::Message() << filter << ", " << channels << ", " << threads);
                const CrewSize size = crew_size(opaque, large.job, Grid(large.job.window), threads);
                // Of corrections without bounds a row takes most.
                const bool most = filter == std::string("ddt-sharp") && channels > 1;
                EXPECT_GE(size.members, most && threads > 16 ? threads * 4 / 5 : threads);
                EXPECT_LE(size.members * TileWorker::memory(large.job, opaque) +
                              size.places * TileMemory::needed(large.job),
                          limit(threads));
            }
        }
}

TEST(CrewSize, AllThreadsWorkOnEightChannelsOfPlainFiltersInAnyOrder) {
    for (const char* filter : {"ddt", "ddt-linear"}) {
        const Large large(filter, 8);
        const ResizeMapping mapping = large.mapping();
        const Opaque opaque(mapping);
        for (size_t threads = 1; threads <= 200; ++threads)
            EXPECT_EQ(crew_size(opaque, large.job, Grid(large.job.window), threads).members,
                      threads)
                << filter;
    }
}

TEST(CrewSize, RowsOfPositionsInAnyOrderTakeMemory) {
    // A row of tiles has 4 million rows of the result, for which a thread takes 64 MiB.
    Large tall("ddt", 1);
    tall.job.window = {0, 0, 1024, 257};
    tall.to = {0, 0, 1024, 1 << 22};
    const ResizeMapping mapping = tall.mapping();
    EXPECT_EQ(tall.of(40).members, 40u);
    const size_t members = crew_size(Opaque(mapping), tall.job, Grid(tall.job.window), 40).members;
    EXPECT_GE(members, 2u);
    EXPECT_LE(members * 64 * mib, limit(40));
}

TEST(CrewSize, NoMoreThanThereIsWorkFor) {
    Large one("ddt", 3);
    one.job.window = {0, 0, 100, 100};
    one.to = {0, 0, 512, 512};
    EXPECT_EQ(one.of(64).places, 1u);
    EXPECT_EQ(one.of(64).members, 4u);
    one.to = {0, 0, 100, 100};
    EXPECT_EQ(one.of(64).members, 1u);
}

TEST(CrewSize, OneOfEachWhateverItTakes) {
    const CrewSize size = Large("ddt", 2000).of(64);
    EXPECT_EQ(size.members, 1u);
    EXPECT_EQ(size.places, 1u);
}

} // namespace
} // namespace ddt::test
