// SPDX-License-Identifier: Apache-2.0
#include "core/base/verbose.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace ddt {
namespace {

TEST(Verbose, IsAnythingSetThatDoesNotBeginWithZero) {
    unsetenv("DDT_VERBOSE");
    EXPECT_FALSE(verbose());
    for (const char* no : {"", "0", "00"}) {
        setenv("DDT_VERBOSE", no, 1);
        EXPECT_FALSE(verbose()) << no;
    }
    for (const char* yes : {"1", "2", "yes"}) {
        setenv("DDT_VERBOSE", yes, 1);
        EXPECT_TRUE(verbose()) << yes;
    }
    unsetenv("DDT_VERBOSE");
}

} // namespace
} // namespace ddt
