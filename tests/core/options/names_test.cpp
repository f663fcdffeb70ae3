// SPDX-License-Identifier: Apache-2.0
#include "ddt/names.h"

#include <gtest/gtest.h>

namespace ddt::test {
namespace {

template <class Value>
void expect_found(const std::vector<std::string>& names, bool (*find)(std::string_view, Value&),
                  const char* (*name_of)(Value)) {
    EXPECT_FALSE(names.empty());
    for (const std::string& name : names) {
        Value value;
        ASSERT_TRUE(find(name, value)) << name;
        EXPECT_EQ(name_of(value), name);
    }
}

TEST(Names, FindWhatTheyName) {
    expect_found(cost_names(), find_cost, cost_name);
    expect_found(start_names(), find_start, start_name);
    expect_found(device_names(), find_device, device_name);
    expect_found(holes_names(), find_holes, holes_name);
    for (const std::string& name : scheme_names()) {
        MeshOptions options;
        ASSERT_TRUE(find_scheme(name, options)) << name;
        EXPECT_EQ(scheme_name(options), name);
    }
}

TEST(Names, TheFamilyHasANumber) {
    MeshOptions options;
    ASSERT_TRUE(find_scheme("exproi7-maxgain", options));
    EXPECT_EQ(options.scheme, Scheme::exproi_n_maxgain);
    EXPECT_EQ(options.wide_iterations, 7);
    EXPECT_EQ(scheme_name(options), "exproi7-maxgain");
    ASSERT_TRUE(find_scheme("exproi400-maxgain", options));
    EXPECT_EQ(options.wide_iterations, 400);
}

TEST(Names, OthersAreNotFoundAndChangeNothing) {
    for (const char* name :
         {"", "exproiN-maxgain", "exproi0-maxgain", "exproi401-maxgain", "exproi-1-maxgain",
          "exproi 2-maxgain", "exproi2", "Lawson", "basic "}) {
        MeshOptions options;
        options.scheme = Scheme::lawson;
        options.wide_iterations = 99;
        EXPECT_FALSE(find_scheme(name, options)) << name;
        EXPECT_EQ(options.scheme, Scheme::lawson);
        EXPECT_EQ(options.wide_iterations, 99);
    }
    Cost cost = Cost::scf;
    EXPECT_FALSE(find_cost("ABN", cost));
    EXPECT_EQ(cost, Cost::scf);
}

} // namespace
} // namespace ddt::test
