// SPDX-License-Identifier: Apache-2.0
// What a job takes from the heap, counted. Plain new and delete of this whole program are replaced
// to that end; what they hand out is malloc's, so that sanitizers see it as ever.
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/tiles/tile_worker.h"
#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"

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

int64_t peak_of(const Job& job) {
    Noise noise(job.channels);
    const int factor = 2;
    const Rect out{0, 0, job.window.width() * factor, job.window.height() * factor};
    const auto mapping = mapping_of(job.window, out, out);
    const int64_t before = heap_now;
    heap_peak = before;
    EXPECT_EQ(enlarge(noise, noise, mapping, job), Outcome::done);
    const int64_t peak = heap_peak - before;
    EXPECT_EQ(heap_now, before); // nothing is left behind
    return peak;
}

TEST(Memory, AJobTakesWhatIsSaidWhateverThePicturesSize) {
    {
        // What a process takes once, whatever it enlarges.
        Job first = plain_job();
        first.window = {0, 0, 8, 8};
        Noise noise(1);
        EXPECT_EQ(
            enlarge(noise, noise, mapping_of(first.window, {0, 0, 16, 16}, {0, 0, 16, 16}), first),
            Outcome::done);
    }
    for (const int channels : {1, 3, 9}) {
        Job job = plain_job();
        job.channels = channels;
        job.mesh.meshes = channels == 3 ? 3 : 1;
        job.threads = 1;
        job.window = {0, 0, 321, 321}; // the largest lattice a tile has
        const int64_t small = peak_of(job);
        job.window = {0, 0, 600, 580};
        const int64_t large = peak_of(job);
        const auto said = int64_t(TileWorker::memory(job));
        EXPECT_LE(large, said) << channels;
        EXPECT_GE(large, said / 3) << channels;
        EXPECT_LE(large, small + small / 4) << channels;
    }
}

} // namespace
} // namespace ddt::test
