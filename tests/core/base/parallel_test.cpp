// SPDX-License-Identifier: Apache-2.0
// Both ways to share work keep the same promises; this file is compiled with each.
#include "core/base/parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace {

TEST(Parallel, EveryIndexOnceAndSlotsOneAtATime) {
    for (const int threads : {1, 2, 5}) {
        std::vector<std::atomic<int>> calls(1000), busy(5);
        ddt::for_each_index(threads, 1000, [&](int slot, int i) {
            ASSERT_TRUE(slot >= 0 && slot < threads);
            EXPECT_EQ(busy[size_t(slot)]++, 0);
            ++calls[size_t(i)];
            --busy[size_t(slot)];
        });
        for (const auto& n : calls)
            EXPECT_EQ(n, 1);
    }
}

TEST(Parallel, OneThreadGoesInOrder) {
    std::vector<int> order;
    ddt::for_each_index(1, 5, [&](int, int i) { order.push_back(i); });
    EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Parallel, NothingToDoIsDone) {
    ddt::for_each_index(4, 0, [](int, int) { FAIL(); });
}

TEST(Parallel, AnExceptionComesOut) {
    for (const int threads : {1, 3}) {
        std::atomic<int> calls{0};
        EXPECT_THROW(ddt::for_each_index(threads, 100000,
                                         [&](int, int) {
                                             ++calls;
                                             throw std::runtime_error("x");
                                         }),
                     std::runtime_error);
        EXPECT_LT(calls, 100000);
    }
}

TEST(Parallel, AtLeastOneThread) {
    EXPECT_GE(ddt::usual_threads(), 1);
    EXPECT_EQ(ddt::allowed_threads(1), 1);
    EXPECT_EQ(ddt::allowed_threads(-3), 1);
    EXPECT_EQ(ddt::threads_for(1), 1);
    for (const int usual : {0, -3})
        EXPECT_EQ(ddt::threads_for(usual), ddt::usual_threads());
}

} // namespace
