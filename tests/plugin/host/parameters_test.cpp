// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/parameters.h"

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "ddt/names.h"
#include "tests/environment.h"
#include "tests/temporary.h"

namespace {

using namespace ddt::host;
using ddt::FilterOptions;
using ddt::OptionKind;

FilterOptions parsed(const std::string& text) {
    FilterOptions options;
    std::string error;
    EXPECT_TRUE(ddt::parse_filter(text, options, error)) << error;
    return options;
}

/// What hosts can say of an option: all, or of numbers those at the ends and those with a name.
std::vector<double> values_of(const Parameter& p) {
    std::vector<double> values;
    if (p.kind == OptionKind::real || p.kind == OptionKind::whole)
        return {p.low, p.initial, p.option->low, p.high};
    for (double value = p.low; value <= p.high; ++value)
        values.push_back(value);
    return values;
}

/// What an option can be: the same of its texts.
std::vector<std::string> texts_of(const Parameter& p) {
    std::vector<std::string> texts;
    for (const ddt::NamedValue& value : p.option->values)
        texts.emplace_back(value.name);
    if (p.option->kind == OptionKind::toggle)
        texts = {"0", "1"};
    if (p.kind == OptionKind::real || p.kind == OptionKind::whole)
        texts.push_back(ddt::number_text(float(p.option->low)));
    return texts;
}

TEST(Parameters, UntouchedTheySayNothing) {
    for (const Parameter& p : parameters())
        EXPECT_EQ(item(p, p.initial), "") << p.option->key;
}

// GTK's and Qt's hosts have their user's.
TEST(Parameters, AHostsDecimalCommaChangesNone) {
    const std::string folder = ddt::temporary("locales");
    std::filesystem::create_directories(folder);
    const std::string make = "localedef -i de_DE -f UTF-8 " + folder + "/de_DE.UTF-8 2>/dev/null";
    const ddt::Environment locales("LOCPATH", folder);
    const bool made = std::system(make.c_str()) == 0 && std::setlocale(LC_ALL, "de_DE.UTF-8");
    if (!made)
        GTEST_SKIP() << "there is no locale with a decimal comma, nor can one be made";
    const bool comma = std::strtod("0,5", nullptr) == 0.5;
    std::vector<double> initial;
    for (const Parameter& p : make_parameters())
        initial.push_back(p.initial);
    std::setlocale(LC_ALL, "C");
    EXPECT_TRUE(comma);
    const std::vector<Parameter> usual = make_parameters();
    ASSERT_EQ(initial.size(), usual.size());
    for (size_t i = 0; i < usual.size(); ++i)
        EXPECT_EQ(initial[i], usual[i].initial) << usual[i].option->key;
}

TEST(Parameters, EveryValueOfAnOptionCanBeSaidOfEveryFilter) {
    for (const Parameter& p : parameters())
        for (const std::string& filter : ddt::filter_names())
            for (const std::string& start : {filter, filter + ",clipped=1"}) {
                if (start.find(std::string(p.option->key) + "=") != start.npos)
                    continue; // untouched it would be what the start says
                std::vector<std::string> reached;
                for (const double value : values_of(p))
                    reached.push_back(p.option->get(parsed(start + item(p, value))));
                for (const std::string& text : texts_of(p))
                    EXPECT_NE(std::find(reached.begin(), reached.end(), text), reached.end())
                        << start << " " << p.option->key << "=" << text;
            }
}

// An expression or a curve of a host may say anything.
TEST(Parameters, OutOfRangeTheNearestEndCounts) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const Parameter& p : parameters()) {
        EXPECT_EQ(item(p, std::nan("")), "") << p.option->key;
        for (const double value : {p.low - 5, p.low - 1e30, -infinity})
            EXPECT_EQ(item(p, value), item(p, p.low)) << p.option->key << " " << value;
        for (const double value : {p.high + 1, p.high * 3 + 7, 1e300, infinity})
            EXPECT_EQ(item(p, value), item(p, p.high)) << p.option->key << " " << value;
        parsed("ddt" + item(p, infinity));
    }
}

// A curve that eases to 0 passes them.
TEST(Parameters, SubnormalsAreZero) {
    for (const Parameter& p : parameters())
        if (p.kind == OptionKind::real)
            for (const double value : {1e-39, -1e-39, 1e-45, 1e-46, 1e-300, 5e-324}) {
                EXPECT_EQ(item(p, value), item(p, 0)) << p.option->key << " " << value;
                parsed("ddt" + item(p, value));
            }
    const auto all = parameters();
    const auto blur = std::find_if(all.begin(), all.end(), [](const Parameter& p) {
        return std::string(p.option->key) == "blur";
    });
    ASSERT_NE(blur, all.end());
    EXPECT_NE(item(*blur, double(std::numeric_limits<float>::min())), item(*blur, 0));
}

TEST(Parameters, BetweenNumbersThatStandForSomethingTheNearestCounts) {
    for (const Parameter& p : parameters()) {
        if (p.kind != OptionKind::real || p.initial != filters_own)
            continue;
        EXPECT_EQ(item(p, -0.5), "") << p.option->key;
        EXPECT_EQ(item(p, -1.2), "") << p.option->key;
        EXPECT_EQ(item(p, -1.9), item(p, p.low)) << p.option->key;
    }
}

} // namespace
