// SPDX-License-Identifier: Apache-2.0
// Processes forked while threads are in their first conversion: farm wrappers and Python's
// multiprocessing do that. A program of its own, whose children start with nothing known.
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "plugin/colour/space_light.h"
#include "tests/child_process.h"

namespace {

bool finds(const std::string& space) {
    std::string error;
    const auto light = ddt::find_light("auto", space, error);
    return light && light->converts();
}

/// Like "Gamma1.37": of these there are as many as one wants, each of them to be analysed.
std::string space(int i) {
    return "Gamma" + std::to_string(1.1 + 0.001 * i);
}

/// The exit status of a child that looks for a light, or -1 if it hangs.
int look_in_child(int i) {
    return ddt::test::in_child([&] { return finds(space(i)) ? 0 : 1; }, 20).code;
}

TEST(Fork, AChildIsNotHeldUpByItsParentsThreads) {
    std::atomic<bool> done{false};
    std::atomic<int> next{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 16; ++i)
        threads.emplace_back([&] {
            while (!done && next < 60)
                EXPECT_TRUE(finds(space(next++)));
        });
    int status = 0;
    for (int i = 0; i < 40 && status == 0; ++i)
        EXPECT_EQ(status = look_in_child(i), 0) << i;
    done = true;
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace
