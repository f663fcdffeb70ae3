// SPDX-License-Identifier: Apache-2.0
#include "core/base/guarded.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace {

using ddt::one_line;

TEST(OneLine, BreaksAndTheBlanksRoundThemBecomeOneBlank) {
    EXPECT_EQ(one_line("one\ntwo"), "one two");
    EXPECT_EQ(one_line("  one \r\n\n\ttwo \n three\n"), "one two three");
    EXPECT_EQ(one_line("a file  with blanks.png"), "a file  with blanks.png");
    EXPECT_EQ(one_line("a"), "a");
    EXPECT_EQ(one_line(""), "");
    EXPECT_EQ(one_line(" \n "), "");
}

TEST(OneLine, IsWhatAGuardedCallTells) {
    std::string error;
    ddt::guarded_call(&error, [] { throw std::runtime_error("one\ntwo\n"); });
    EXPECT_EQ(error, "ddt: one two");
    EXPECT_FALSE(ddt::succeeds(&error, [](std::string& why) {
        why = "ddt: three\nfour";
        return false;
    }));
    EXPECT_EQ(error, "ddt: three four");
}

} // namespace
