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
    EXPECT_EQ(one_line("twice\ntwice\n once"), "twice once");
    EXPECT_EQ(one_line(""), "");
    EXPECT_EQ(one_line(" \n "), "");
}

TEST(OneLine, HoldsNothingThatATerminalObeys) {
    EXPECT_EQ(one_line("\033[2Jred\a.png"), "?[2Jred?.png");
    EXPECT_EQ(one_line("a\177b"), "a?b");
    EXPECT_EQ(one_line("a\xC2\x9B"
                       "31mb"),
              "a?31mb");
    EXPECT_EQ(one_line(std::string("a\0b", 3)), "a?b");
    // Letters, the first character after those, and tabs stay, as does what is no UTF-8.
    const std::string letters = "\u00e9\u00a0\u3042\tb\U0001F600\u00df";
    EXPECT_EQ(one_line(letters), letters);
    EXPECT_EQ(one_line("a\xC2"), "a\xC2");
    EXPECT_EQ(one_line("\xE9t\xE9"), "\xE9t\xE9");
}

/// Which Latin-1 has too.
TEST(OneLine, HoldsNoControlCharactersOfOneByte) {
    EXPECT_EQ(one_line("a\x9B"
                       "31mb\x80\x9F\xA0"),
              "a?31mb??\xA0");
    // Of a character that is cut off, and of longer forms than need be.
    EXPECT_EQ(one_line("\xE3\x81"
                       "b"),
              "\xE3?b");
    EXPECT_EQ(one_line("\xC1\x9B\xE0\x82\x9B\xF0\x80\x82\x9B\xF5\x80\x80\x80"),
              "\xC1?\xE0??\xF0???\xF5???");
}

TEST(OneLine, OfWhatIsTooLongTheTwoEndsStay) {
    const std::string name(5000, 'x'), line = one_line("cannot open " + name + ": no such file");
    EXPECT_LE(line.size(), ddt::longest_line);
    EXPECT_EQ(line.compare(0, 14, "cannot open xx"), 0);
    EXPECT_NE(line.find("xx ... xx"), std::string::npos);
    EXPECT_EQ(line.substr(line.size() - 16), "xx: no such file");
    // Characters of two bytes are not cut.
    std::string letters = "a";
    for (int i = 0; i < 3000; ++i)
        letters += "\u00e9";
    for (const char* before : {"", "b"}) {
        const std::string cut = one_line(before + letters);
        const size_t dots = cut.find(" ... ");
        ASSERT_NE(dots, std::string::npos);
        EXPECT_EQ(dots % 2, before[0] ? 0u : 1u);
        EXPECT_EQ((cut.size() - dots - 5) % 2, 0u);
    }
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
