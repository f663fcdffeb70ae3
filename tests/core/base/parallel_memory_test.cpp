// SPDX-License-Identifier: Apache-2.0
// Threads for which there is no memory: those that are there do the work.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "core/base/parallel.h"

namespace {

std::atomic<int> left{1 << 30}; ///< allocations that succeed

} // namespace

// Not inlined: compilers would take one for the other's.
[[gnu::noinline]] void* operator new(size_t size) {
    if (left-- > 0)
        if (void* const p = std::malloc(size ? size : 1))
            return p;
    throw std::bad_alloc();
}
// What std::stable_sort() asks for; without it another's would be given to our delete.
[[gnu::noinline]] void* operator new(size_t size, const std::nothrow_t&) noexcept {
    return left-- > 0 ? std::malloc(size ? size : 1) : nullptr;
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
    std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, size_t) noexcept {
    std::free(p);
}

namespace {

TEST(ParallelMemory, MissingIsNoEnd) {
    constexpr int count = 100;
    int done = 0;
    for (int allowed = 0; allowed < 20; ++allowed) {
        std::atomic<int> calls{0};
        const std::function<void(int, int)> body = [&](int, int) { ++calls; };
        left = allowed;
        try {
            ddt::for_each_index(4, count, body);
        } catch (const std::bad_alloc&) {
            calls = -1; // before it has begun
        }
        left = 1 << 30;
        EXPECT_TRUE(calls == count || calls == -1) << allowed << ": " << calls;
        done += calls == count;
    }
    EXPECT_GT(done, 10);
}

} // namespace
