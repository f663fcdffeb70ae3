// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ddt/names.h"
#include "ddt/option_table.h"

namespace ddt::test {
namespace {

TEST(Filters, FilterNames) {
    EXPECT_TRUE(is_filter_name("ddt"));
    EXPECT_TRUE(is_filter_name("ddt-linear"));
    EXPECT_TRUE(is_filter_name("ddt,light=encoded"));
    EXPECT_TRUE(is_filter_name("ddt,nonsense"));
    EXPECT_FALSE(is_filter_name(""));
    EXPECT_FALSE(is_filter_name("ddtx"));
    EXPECT_FALSE(is_filter_name("lanczos3"));
    EXPECT_FALSE(is_filter_name("lanczos3,ddt"));
}

TEST(Filters, EachHasAHelpOfItsOwn) {
    std::vector<std::string> helps = {""};
    for (const std::string& filter : filter_names()) {
        const std::string help = filter_help(filter);
        EXPECT_EQ(std::count(helps.begin(), helps.end(), help), 0) << filter;
        helps.push_back(help);
    }
    for (const char* name : {"", "lanczos3", "ddtx", "ddt,cost=abn"})
        EXPECT_EQ(filter_help(name), "") << name;
}

} // namespace
} // namespace ddt::test
