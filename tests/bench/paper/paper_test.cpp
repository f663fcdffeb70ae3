// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "ddt/names.h"
#include "growth.h"
#include "paper/subject.h"
#include "paper/table.h"

namespace paper {
namespace {

TEST(Table, TextIsAlignedAndCsvIsNot) {
    Table table("name", {"scheme", "cost"});
    table.add({"a", "1.5"});
    table.add({"longer one", "10.25"});
    EXPECT_EQ(table.text(), "name\n"
                            "scheme       cost\n"
                            "a             1.5\n"
                            "longer one  10.25\n");
    EXPECT_EQ(table.csv(), "scheme,cost\na,1.5\nlonger one,10.25\n");
    EXPECT_FALSE(table.show("/no/such/folder"));
}

TEST(Table, Number) {
    EXPECT_EQ(number(1.25, 1), "1.2");
    EXPECT_EQ(number(-3, 0), "-3");
}

TEST(GrowthExponent, OfPowers) {
    EXPECT_NEAR(bench::growth_exponent({{1, 2}, {2, 4}, {8, 16}}), 1, 1e-12);
    EXPECT_NEAR(bench::growth_exponent({{1, 3}, {2, 12}, {4, 48}}), 2, 1e-12);
    EXPECT_NEAR(bench::growth_exponent({{1, 5}, {3, 5}, {4, 5}}), 0, 1e-12);
}

TEST(Schemes, AllOfThePapersAreThereOnce) {
    std::vector<std::string> labels;
    for (const ddt::MeshOptions& o : all_schemes()) {
        EXPECT_EQ(o.cost, ddt::Cost::scf);
        labels.push_back(label(o));
    }
    for (const char* name : {"lawson", "basic", "exproi", "maxgain", "exproi-maxgain",
                             "exproi2-maxgain", "one-round", "one-round (flat start)"})
        EXPECT_EQ(std::count(labels.begin(), labels.end(), name), 1) << name;
}

TEST(Reduce, BilinearIsTheMeanOfTheFourPixelsInTheMiddle) {
    metrics::Plane plane(8, 4);
    for (size_t i = 0; i < plane.values.size(); ++i)
        plane.values[i] = double(i);
    const metrics::Image image{{plane, plane, plane}};
    const metrics::Image by4 = reduce(image, 4, Reduce::bilinear);
    ASSERT_EQ(by4.width(), 2);
    ASSERT_EQ(by4.height(), 1);
    // 9, 10, 17, 18 and 13, 14, 21, 22; rounded.
    EXPECT_NEAR(by4.channels[0].at(0, 0), 13.5, 0.5);
    EXPECT_NEAR(by4.channels[0].at(1, 0), 17.5, 0.5);
    EXPECT_EQ(reduce(image, 2, Reduce::bilinear).channels[1].at(0, 0), 5); // 0, 1, 8, 9: 4.5
}

TEST(Guide, IsLumaInStepsOf4096) {
    metrics::Image image{
        {metrics::Plane(2, 1, 255), metrics::Plane(2, 1, 255), metrics::Plane(2, 1, 255)}};
    image.channels[0].at(1, 0) = 0;
    const auto guide = guide_of(image);
    ASSERT_EQ(guide.size(), 2u);
    EXPECT_EQ(guide[0], 1.0f);
    EXPECT_EQ(guide[1], std::round(0.701f * 4096) / 4096);
}

} // namespace
} // namespace paper
