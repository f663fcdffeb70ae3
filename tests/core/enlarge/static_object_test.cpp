// SPDX-License-Identifier: Apache-2.0
// A static object whose constructor enlarges, and so does its destructor.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "ddt/core.h"

namespace {

/// Twice as large, on the device that a job is given unless somebody says otherwise. Whether all
/// pixels were written.
bool enlarges() {
    constexpr int side = 300;
    unsetenv("DDT_DEVICE");
    const std::vector<float> small(size_t(side) * side, 0.5f);
    std::vector<float> large(4 * small.size());
    return ddt::enlarge(small.data(), side, side, 1, nullptr, large.data(), 2 * side, 2 * side) ==
               ddt::Outcome::done &&
           std::count(large.begin(), large.end(), 0.5f) == std::ptrdiff_t(large.size());
}

struct Enlarging {
    const bool did = enlarges();
    ~Enlarging() {
        if (!enlarges())
            std::_Exit(1);
    }
} enlarging;

TEST(StaticObject, EnlargesInItsConstructorAndItsDestructor) {
    EXPECT_TRUE(enlarging.did);
}

} // namespace
