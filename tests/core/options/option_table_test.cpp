// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/cost/cost.h"
#include "core/gl/offload.h"
#include "ddt/names.h"
#include "ddt/option_table.h"

namespace ddt::test {
namespace {

/// A value of the option that is not its default in any filter.
std::string other_value(const Option& option) {
    switch (option.kind) {
    case OptionKind::real:
        return number_text(float(option.high) * 0.75f);
    case OptionKind::whole:
        return std::to_string(int64_t(option.high) - 1);
    case OptionKind::toggle:
        return "1";
    case OptionKind::choice:
        return option.values.back().name;
    case OptionKind::text:
        return "ACEScg";
    }
    return "";
}

/// The texts of all options.
std::vector<std::string> texts_of(const FilterOptions& options) {
    std::vector<std::string> values;
    for (const Option& option : option_table())
        values.push_back(option.get(options));
    return values;
}

TEST(OptionTable, EveryKey) {
    for (const Option& option : option_table()) {
        const std::string value = other_value(option);
        for (const std::string& filter : filter_names()) {
            FilterOptions options, plain;
            std::string error;
            ASSERT_TRUE(parse_filter(filter, plain, error)) << error;
            ASSERT_TRUE(parse_filter(filter + "," + option.key + "=" + value, options, error))
                << error;
            EXPECT_EQ(option.get(options), value) << option.key;
            EXPECT_NE(option.get(plain), value) << option.key;
            EXPECT_EQ(option.get(plain), default_text(option, filter));
            // No other option follows, but for those whose default depends on others
            // (Option::holds).
            for (const Option& other : option_table())
                if (&other != &option && !other.holds) {
                    EXPECT_EQ(other.get(options), other.get(plain)) << option.key << other.key;
                }
            ASSERT_TRUE(check_options(options, error)) << error;
            ASSERT_TRUE(set_option(std::string(option.key) + "=" + value, plain, error));
            EXPECT_EQ(option.get(plain), value);
        }
    }
}

TEST(OptionTable, EveryNamedValueIsOneAndItsOwn) {
    for (const Option& option : option_table())
        for (const NamedValue& value : option.values) {
            FilterOptions options;
            ASSERT_TRUE(option.set(options, value.name)) << option.key << "=" << value.name;
            EXPECT_EQ(option.get(options), value.name);
            EXPECT_NE(std::string(value.help), "");
        }
}

TEST(OptionTable, HelpTellsFromWhichSizesAGpuIsTaken) {
    const std::string help = find_option("device")->values[0].help;
    EXPECT_NE(help.find("for each CPU thread " + std::to_string(worth_using) +
                        " source pixels, or " + std::to_string(worth_opening) + " ("),
              std::string::npos);
}

TEST(OptionTable, FiveDefaultsDependOnOthers) { // as parse_filter() is told to
    std::string keys;
    for (const Option& option : option_table())
        if (option.holds)
            keys += std::string(" ") + option.key;
    EXPECT_EQ(keys, " contour min_gain iterations fitted soft");
}

TEST(OptionTable, HelpTellsTheNumbersThatCount) {
    const auto said = [](const std::string& help, const std::string& words) {
        return help.find(words) != std::string::npos;
    };
    const std::string spread = number_text(mesh_spread);
    EXPECT_TRUE(
        said(find_option("meshes")->help, "`blur` - " + spread + " to `blur` + " + spread + ","));
    EXPECT_EQ(std::string(find_option("min_gain")->values[0].help)
                  .rfind(number_text(traits(Cost::abn).min_gain) + " with `abn`,", 0),
              0u);
    const Option& iterations = *find_option("iterations");
    EXPECT_TRUE(said(iterations.help,
                     "Unless given, " + std::string(iterations.otherwise) + " with `annealing`."));
}

TEST(OptionTable, DefaultsAreTheFirstFilter) {
    const FilterOptions plain;
    for (const Option& option : option_table())
        EXPECT_EQ(option.get(plain), default_text(option, "ddt")) << option.key;
    EXPECT_EQ(plain.surface.kind, Surface::patch);
}

TEST(OptionTable, OnlyNegativeNumbersHaveTheirName) {
    const Option& option = *find_option("min_gain");
    FilterOptions options;
    ASSERT_TRUE(option.set(options, "-0"));
    EXPECT_EQ(option.get(options), "-0");
    options.mesh.min_gain = -1;
    EXPECT_EQ(option.get(options), "auto");
    std::string error;
    for (const float nan : {std::nanf(""), -std::nanf("")}) {
        options.mesh.min_gain = nan;
        EXPECT_FALSE(check_options(options, error));
    }
}

TEST(OptionTable, WhatIsNotAllowedIsNotSet) {
    for (const Option& option : option_table()) {
        std::vector<std::string> refused = {"", "no,such", ","};
        if (option.kind != OptionKind::text)
            for (const char* value : {"no such", "-1", " 1", "1x", "exproi0-maxgain", "nan"})
                refused.emplace_back(value);
        if (option.kind == OptionKind::toggle || option.kind == OptionKind::whole)
            refused.push_back(std::to_string(int64_t(option.high) + 1));
        if (option.kind == OptionKind::real)
            refused.push_back(number_text(float(option.high) * 1.5f));
        for (const std::string& value : refused) {
            SCOPED_TRACE(std::string(option.key) + "=" + value);
            FilterOptions options; // not the defaults: setting these would be seen too
            for (const Option& other : option_table())
                ASSERT_TRUE(other.set(options, other_value(other)));
            const std::vector<std::string> before = texts_of(options);
            EXPECT_FALSE(option.set(options, value));
            EXPECT_EQ(texts_of(options), before);
            std::string error;
            EXPECT_FALSE(set_option(std::string(option.key) + "=" + value, options, error));
            EXPECT_EQ(error.rfind("ddt: option \"" + std::string(option.key) + "=", 0), 0u)
                << error;
            EXPECT_NE(error.find(option.allowed()), std::string::npos) << error;
            EXPECT_EQ(error.find('\n'), std::string::npos) << error;
            EXPECT_EQ(texts_of(options), before);
        }
    }
    for (const char* item : {"colour=red", "cost", "", "=abn"}) {
        FilterOptions options;
        std::string error;
        EXPECT_FALSE(set_option(item, options, error)) << item;
        EXPECT_EQ(error.rfind("ddt: ", 0), 0u) << error;
        EXPECT_EQ(texts_of(options), texts_of({})) << item;
    }
}

TEST(OptionTable, FindsWhatIsThereAlone) {
    for (const char* key : {"", "colour", "cos", "costs", "Cost", "cost="})
        EXPECT_EQ(find_option(key), nullptr) << key;
    for (const Option& option : option_table())
        EXPECT_EQ(find_option(option.key), &option);
}

} // namespace
} // namespace ddt::test
