// SPDX-License-Identifier: Apache-2.0
// What a job takes from the heap, counted. Plain new and delete of this whole program are replaced
// to that end; what they hand out is malloc's, so that sanitizers see it as ever.
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <utility>

#include "core/tiles/tile_worker.h"
#include "ddt/points.h"
#include "tests/core/gathering.h"
#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"
#include "tests/many_threads.h"

namespace {

std::atomic<int64_t> heap_now{0}, heap_peak{0};

} // namespace

// Not inlined, or the compiler takes malloc and delete for a mismatched pair.
__attribute__((noinline)) void* operator new(size_t size) {
    void* p = std::malloc(size ? size : 1);
    if (!p)
        throw std::bad_alloc();
    const int64_t now = heap_now += int64_t(malloc_usable_size(p));
    int64_t peak = heap_peak;
    while (now > peak && !heap_peak.compare_exchange_weak(peak, now)) {
    }
    return p;
}
void* operator new[](size_t size) {
    return operator new(size);
}
void* operator new(size_t size, const std::nothrow_t&) noexcept {
    try {
        return operator new(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
__attribute__((noinline)) void operator delete(void* p) noexcept {
    if (p)
        heap_now -= int64_t(malloc_usable_size(p));
    std::free(p);
}
void operator delete[](void* p) noexcept {
    operator delete(p);
}
void operator delete(void* p, size_t) noexcept {
    operator delete(p);
}
void operator delete[](void* p, size_t) noexcept {
    operator delete(p);
}

namespace ddt::test {
namespace {

/// Reads noise and drops results, holding nothing itself.
class Noise final : public Source, public Sink {
public:
    explicit Noise(int channels) : m_channels(size_t(channels)) {}
    bool read(const Rect& r, float* values, float* guide) override {
        Random random(uint64_t(r.x0) * 1000 + uint64_t(r.y0));
        for (size_t i = 0; i < r.area(); ++i) {
            guide[i] = float(random.below(4097)) / 4096.0f;
            std::fill(values + i * m_channels, values + (i + 1) * m_channels, guide[i]);
        }
        return true;
    }
    bool write(const Rect&, float*) override { return true; }

private:
    size_t m_channels;
};

/// Of a process that keeps nothing.
int64_t peak_of(const Job& job, const Mapping& mapping) {
    Noise noise(job.channels);
    release_memory();
    const int64_t before = heap_now;
    heap_peak = before;
    EXPECT_EQ(enlarge(noise, noise, mapping, job), Outcome::done);
    const int64_t peak = heap_peak - before;
    release_memory();
    // Nothing is left behind, but for the few bytes of a thread that oneTBB has kept.
    EXPECT_LE(heap_now, before + (job.threads > 1 ? 256 * job.threads : 0));
    return peak;
}

/// Of enlarging the window to `to`, of which `out` is wanted.
int64_t peak_of(const Job& job, const Rect& to, const Rect& out) {
    return peak_of(job, mapping_of(job.window, to, out));
}

int64_t peak_of(const Job& job) {
    const Rect out{0, 0, job.window.width() * 2, job.window.height() * 2};
    return peak_of(job, out, out);
}

/// What a process takes once, whatever it enlarges.
void warm_up(int threads) {
    Job first = plain_job();
    first.window = {0, 0, 8, 8};
    first.threads = threads;
    Noise noise(1);
    const Rect out{0, 0, 16, 16};
    EXPECT_EQ(enlarge(noise, noise, mapping_of(first.window, out, out), first), Outcome::done);
}

Job job_of(const char* filter, const Rect& window, int channels, int threads) {
    Job job;
    job.window = window;
    job.channels = channels;
    set_filter(filter, job);
    job.threads = threads;
    job.device = Device::cpu;
    return job;
}

/// Of one thread.
int64_t memory_said(const Job& job, const Mapping& mapping) {
    return int64_t(TileWorker::memory(job, mapping) + TileMemory::needed(job));
}

constexpr int64_t mib = int64_t(1) << 20;
constexpr int64_t promised = 256 * mib;

TEST(Memory, AJobTakesWhatIsSaidWhateverThePicturesSize) {
    warm_up(1);
    for (const int channels : {1, 3, 9}) {
        Job job = plain_job();
        job.channels = channels;
        job.mesh.meshes = channels == 3 ? 3 : 1;
        job.threads = 1;
        job.window = {0, 0, 321, 321}; // the largest lattice a tile has
        const int64_t small = peak_of(job);
        job.window = {0, 0, 600, 580};
        const int64_t large = peak_of(job);
        const Rect out{0, 0, 1200, 1160};
        const int64_t said = memory_said(job, mapping_of(job.window, out, out));
        EXPECT_LE(large, said) << channels;
        EXPECT_GE(large, said / 3) << channels;
        EXPECT_LE(large, small + small / 4) << channels;
    }
}

TEST(Memory, LongRowsTakeNoMoreThanShortOnes) {
    warm_up(1);
    const Rect wide{0, 0, 1 << 24, 1};
    EXPECT_LE(peak_of(job_of("ddt", {0, 0, 2, 1}, 1, 1), wide, wide), 4 * mib);
    const Rect tall{0, 0, 1 << 16, 4};
    EXPECT_LE(peak_of(job_of("ddt-sharp", {0, 0, 40, 3}, 5, 1), tall, tall), 8 * mib);
}

TEST(Memory, NothingIsTakenOrReadOfAnImageTooLargeToBeFilled) {
    class Unread final : public Source {
        bool read(const Rect&, float*, float*) override {
            ADD_FAILURE() << "read";
            return false;
        }
    } source;
    warm_up(1);
    Job job = plain_job();
    job.window = {-5, 7, (1 << 16) - 5, (1 << 15) + 7}; // 2^31
    job.threads = 1;
    Noise sink(1);
    std::string error;
    const ResizeMapping mapping = mapping_of(job.window, job.window, job.window);
    for (const Holes holes : {Holes::fill, Holes::fill_alpha}) {
        job.holes = holes;
        const int64_t before = heap_now;
        heap_peak = before;
        EXPECT_EQ(enlarge(source, sink, mapping, job, &error), Outcome::bad_job);
        EXPECT_LE(heap_peak - before, mib);
        EXPECT_NE(error.find("2147483647 pixels"), std::string::npos) << error;
    }
}

TEST(Memory, ManyChannelsTakeWhatIsPromised) {
    warm_up(1);
    const Rect window{0, 0, 321, 321}, to{0, 0, 642, 642};
    // All of the tile is worked on for a few of its rows.
    const Rect out{300, 300, 342, 304};
    EXPECT_LE(peak_of(job_of("ddt", window, 256, 1), to, out), promised);
    EXPECT_LE(peak_of(job_of("ddt-sharp", window, 64, 1), to, out), promised);
    EXPECT_LE(peak_of(job_of("ddt-sharp,clipped=1", window, 64, 1), to, out), promised);
}

TEST(Memory, AWorkerTakesWhatIsSaidOfIt) {
    warm_up(1);
    const Rect window{0, 0, 600, 580}, to{0, 0, 1200, 1160};
    // The tile in the middle, with halos all round.
    const ResizeMapping resized = mapping_of(window, to, {520, 520, 1020, 560});
    const Opaque turned(resized);
    for (const char* filter : {"ddt", "ddt-linear", "ddt-sharp", "ddt-sharp,clipped=1"})
        for (const int channels : {3, 9}) {
            const Job job = job_of(filter, window, channels, 1);
            EXPECT_LE(peak_of(job, resized), memory_said(job, resized)) << filter;
            EXPECT_LE(peak_of(job, turned), memory_said(job, turned)) << filter;
            // The corner's tile is smaller than the one after it: nothing grows to twice of it.
            EXPECT_LE(peak_of(job, to, {0, 0, 1200, 8}), memory_said(job, resized)) << filter;
        }
    for (const char* scheme : {"basic", "exproi", "maxgain", "exproi-maxgain", "exproi2-maxgain",
                               "annealing", "look-ahead", "lawson", "pixel"}) {
        const Job job = job_of((std::string("ddt,scheme=") + scheme).c_str(), window, 3, 1);
        EXPECT_LE(peak_of(job, resized), memory_said(job, resized)) << scheme;
        // Nor so much that threads would stand by for nothing.
        EXPECT_GE(peak_of(job, resized), memory_said(job, resized) * 4 / 5) << scheme;
    }
    // As docs/scale.md says.
    EXPECT_LE(peak_of(job_of("ddt", window, 3, 1), resized), 6 * mib);
    EXPECT_LE(peak_of(job_of("ddt-linear", window, 3, 1), resized), 6 * mib);
    EXPECT_LE(peak_of(job_of("ddt-sharp", window, 1, 1), resized), 6 * mib);
    EXPECT_LE(peak_of(job_of("ddt-sharp,clipped=1", window, 3, 1), resized), 6.2 * mib);
    EXPECT_LE(peak_of(job_of("ddt-sharp", window, 3, 1), resized), 7.7 * mib);
    EXPECT_LE(peak_of(job_of("ddt", window, 3, 1), turned), 7 * mib);
    EXPECT_LE(peak_of(job_of("ddt-sharp", window, 3, 1), turned), 9 * mib);
}

TEST(Memory, OfPositionsInAnyOrderRowsAreCounted) {
    warm_up(1);
    const Rect tall{0, 0, 1, 1 << 20};
    const Job job = job_of("ddt", {0, 0, 2, 3}, 1, 1);
    const ResizeMapping resized = mapping_of(job.window, tall, tall);
    const Opaque turned(resized);
    const int64_t peak = peak_of(job, turned);
    EXPECT_GE(peak, 16 * mib);
    EXPECT_LE(peak, memory_said(job, turned));
}

/// Noise, until so many threads write at once, or for a minute; fails then.
class Crowd final : public Source, public Sink {
public:
    Crowd(int channels, int wanted) : writing(wanted), m_noise(channels) {}
    bool read(const Rect& r, float* values, float* guide) override {
        return m_noise.read(r, values, guide);
    }
    bool write(const Rect&, float*) override {
        const Gathering::Guest here(writing);
        return false;
    }

    Gathering writing;

private:
    Noise m_noise;
};

TEST(Memory, AllThreadsThatAreAskedForWork) {
    const ManyThreads many(128);
    const Rect to{0, 0, 32768, 16384};
    const Rect window{0, 0, 16384, 8192};
    const ResizeMapping resized = mapping_of(window, to, to);
    const Opaque turned(resized);
    const auto all_work = [&](int threads, int channels, const Mapping& mapping) {
        for (const char* filter : {"ddt", "ddt-linear", "ddt-sharp", "ddt-sharp,clipped=1"}) {
            const Job job = job_of(filter, window, channels, threads);
            Crowd crowd(channels, threads);
            warm_up(threads);
            release_memory();
            const int64_t before = heap_now;
            heap_peak = before;
            EXPECT_EQ(enlarge(crowd, crowd, mapping, job), Outcome::sink_failed);
            EXPECT_EQ(crowd.writing.most(), threads) << filter;
            // As ddt/job.h says.
            EXPECT_LE(heap_peak - before, 200 * mib + (std::max(threads, 40) - 40) * 6 * mib)
                << filter;
        }
    };
    all_work(16, 3, resized);
    all_work(16, 4, resized);
    all_work(40, 3, resized);
    all_work(40, 4, resized);
    all_work(128, 4, resized);
    all_work(16, 4, turned);
    all_work(128, 3, turned);
}

TEST(Memory, StaysForTheNextJobAndNoMoreThanIsSaid) {
    constexpr int threads = 8;
    const ManyThreads many(threads);
    warm_up(threads);
    const Rect window{0, 0, 321, 321}, to{0, 0, 642, 642};
    const auto kept_by = [&](const Job& job, const Rect& size, const Rect& out) {
        release_memory();
        const int64_t before = heap_now;
        Noise noise(job.channels);
        EXPECT_EQ(enlarge(noise, noise, mapping_of(job.window, size, out), job), Outcome::done);
        return heap_now - before;
    };
    const Job job = job_of("ddt", window, 3, 1);
    const int64_t kept = kept_by(job, to, to);
    EXPECT_GE(kept, 4 * mib);
    // The next takes it, gives it back, and needs little more.
    const int64_t before = heap_now;
    heap_peak = before;
    Noise noise(3);
    EXPECT_EQ(enlarge(noise, noise, mapping_of(window, to, to), job), Outcome::done);
    EXPECT_LE(heap_peak - before, 4 * mib);
    EXPECT_EQ(heap_now, before);
    // As ddt/job.h says: of two threads, if neither takes more than 12 MiB.
    const Rect large{0, 0, 1024, 1024}, of_large{0, 0, 2048, 2048};
    EXPECT_LE(kept_by(job_of("ddt", large, 3, threads), of_large, of_large), 24 * mib);
    EXPECT_LE(kept_by(job_of("ddt", window, 64, 1), to, {0, 0, 642, 2}), mib);
    release_memory();
}

TEST(Memory, SomeThreadsTakeWhatIsPromisedForAll) {
    constexpr int threads = 16;
    const ManyThreads many(threads);
    warm_up(threads);
    const Rect window{0, 0, 1024, 1024}, to{0, 0, 1025, 1025};
    for (const char* filter : {"ddt", "ddt-sharp"})
        EXPECT_LE(peak_of(job_of(filter, window, 3, threads), to, to), 200 * mib) << filter;
}

// However long the other side of the grid is.
TEST(Memory, OfDrawingNoPixelsIsThatOfAMesh) {
    const PointMesh mesh{{0, 2, 0}, {0, 0, 2}, {{0, 1, 2}}};
    const float values[3] = {};
    for (const auto& [width, height] : {std::pair{1 << 20, 0}, std::pair{0, 1 << 20}}) {
        const int64_t before = heap_now;
        heap_peak = before;
        EXPECT_TRUE(draw(mesh, values, 1, {0, 0, 1, 1, width, height}, nullptr, nullptr));
        EXPECT_LT(heap_peak - before, 1 << 16);
    }
}

} // namespace
} // namespace ddt::test
