// SPDX-License-Identifier: Apache-2.0
#include "ddt/names.h"

#include <gtest/gtest.h>

namespace ddt::test {
namespace {

TEST(Names, FindWhatTheyName) {
    for (const std::string& name : device_names()) {
        Device device;
        ASSERT_TRUE(find_device(name, device));
        EXPECT_EQ(device_name(device), name);
    }
    for (const std::string& name : holes_names()) {
        Holes holes;
        ASSERT_TRUE(find_holes(name, holes));
        EXPECT_EQ(holes_name(holes), name);
    }
    for (const std::string& name : cost_names()) {
        Cost cost;
        ASSERT_TRUE(find_cost(name, cost));
        EXPECT_EQ(cost_name(cost), name);
    }
    for (const std::string& name : start_names()) {
        Start start;
        ASSERT_TRUE(find_start(name, start));
        EXPECT_EQ(start_name(start), name);
    }
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
    ASSERT_TRUE(find_scheme("exproi250-maxgain", options));
    EXPECT_EQ(options.wide_iterations, 250);
}

TEST(Names, OthersAreNotFoundAndChangeNothing) {
    for (const char* name :
         {"", "exproiN-maxgain", "exproi0-maxgain", "exproi251-maxgain", "exproi-1-maxgain",
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
