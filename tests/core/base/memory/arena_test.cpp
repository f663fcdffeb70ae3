// SPDX-License-Identifier: Apache-2.0
#include "core/base/memory/arena.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace ddt::test {
namespace {

TEST(Arena, PiecesAreOnLinesOfTheirOwn) {
    Arena arena;
    arena.reserve(1000);
    std::vector<char*> pieces;
    // Beyond what it has room for, too.
    for (size_t bytes = 1; bytes < 300; bytes += 7) {
        auto* const p = static_cast<char*>(arena.take(bytes));
        EXPECT_EQ(reinterpret_cast<uintptr_t>(p) % Arena::line, 0u);
        std::memset(p, int(bytes % 256), bytes);
        pieces.push_back(p);
    }
    for (size_t i = 0; i < pieces.size(); ++i)
        for (size_t k = 0; k < 1 + 7 * i; ++k)
            ASSERT_EQ(static_cast<unsigned char>(pieces[i][k]), (1 + 7 * i) % 256);
}

TEST(Arena, HasRoomForWhatItHadNoRoomFor) {
    if (Arena::apart)
        GTEST_SKIP() << "there is no block";
    Arena arena;
    arena.reserve(128);
    arena.take(100);
    arena.take(1000);
    arena.take(5000);
    EXPECT_EQ(arena.bytes(), 128u);
    arena.clear();
    EXPECT_EQ(arena.bytes(), 128u + 1024 + 5056);
    // The same memory from now on.
    const auto all = [&] {
        return std::set<const void*>{arena.take(100), arena.take(1000), arena.take(5000)};
    };
    const auto again = all();
    arena.clear();
    EXPECT_EQ(all(), again);
    EXPECT_EQ(arena.bytes(), 128u + 1024 + 5056);
}

TEST(Arena, VectorsGrowAndMoveAndLeaveNewNumbersAsTheyAre) {
    Arena arena;
    ArenaVector<int> in_arena(&arena), on_heap;
    int numbers[50];
    for (int i = 0; i < 50; ++i)
        numbers[i] = i * i;
    for (ArenaVector<int>* v : {&in_arena, &on_heap}) {
        for (int i = 0; i < 50; ++i)
            v->push_back(numbers[i]);
        append(*v, numbers, 50);
        append(*v, numbers, 0);
        ASSERT_EQ(v->size(), 100u);
        for (size_t i = 0; i < 100; ++i)
            EXPECT_EQ((*v)[i], numbers[i % 50]);
        // What stood there stays.
        v->resize(10);
        v->resize(60);
        EXPECT_EQ((*v)[59], numbers[9]);
    }
    // Assigned to, it goes over to the other's memory.
    in_arena = ArenaVector<int>();
    EXPECT_EQ(in_arena.get_allocator().arena, nullptr);
    arena.clear();
    in_arena.assign(3, 7);
    EXPECT_EQ(in_arena.back(), 7);
}

} // namespace
} // namespace ddt::test
