// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/base/float_mode.h"
#include "core/gl/offload.h"
#include "ddt/core.h"
#include "ddt/names.h"
#include "ddt/option_table.h"
#include "tests/core/host_floats.h"

namespace {

std::string error_of(const char* spec) {
    ddt::FilterOptions options;
    std::string error;
    EXPECT_FALSE(ddt::parse_filter(spec, options, error)) << spec;
    EXPECT_EQ(error.find('\n'), std::string::npos);
    return error;
}

TEST(Options, FilterNames) {
    EXPECT_TRUE(ddt::is_filter_name("ddt"));
    EXPECT_TRUE(ddt::is_filter_name("ddt-linear"));
    EXPECT_TRUE(ddt::is_filter_name("ddt,light=encoded"));
    EXPECT_TRUE(ddt::is_filter_name("ddt,nonsense"));
    EXPECT_FALSE(ddt::is_filter_name(""));
    EXPECT_FALSE(ddt::is_filter_name("ddtx"));
    EXPECT_FALSE(ddt::is_filter_name("lanczos3"));
    EXPECT_FALSE(ddt::is_filter_name("lanczos3,ddt"));
}

TEST(Options, NameSetsSurface) {
    ddt::FilterOptions options;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt-linear", options, error));
    EXPECT_EQ(options.surface.kind, ddt::Surface::linear);
    ASSERT_TRUE(ddt::parse_filter("ddt", options, error));
    EXPECT_EQ(options.surface.kind, ddt::Surface::patch);
}

/// A value of the option that is not its default in any filter.
std::string other_value(const ddt::Option& option) {
    switch (option.kind) {
    case ddt::OptionKind::real:
        return ddt::number_text(float(option.high) * 0.75f);
    case ddt::OptionKind::whole:
        return std::to_string(int64_t(option.high));
    case ddt::OptionKind::toggle:
        return "1";
    case ddt::OptionKind::choice:
        return option.values.back().name;
    case ddt::OptionKind::text:
        return "ACEScg";
    }
    return "";
}

TEST(Options, EveryKey) {
    for (const ddt::Option& option : ddt::option_table()) {
        const std::string value = other_value(option);
        for (const std::string& filter : ddt::filter_names()) {
            ddt::FilterOptions options, plain;
            std::string error;
            ASSERT_TRUE(ddt::parse_filter(filter, plain, error)) << error;
            ASSERT_TRUE(ddt::parse_filter(filter + "," + option.key + "=" + value, options, error))
                << error;
            EXPECT_EQ(option.get(options), value) << option.key;
            EXPECT_NE(option.get(plain), value) << option.key;
            EXPECT_EQ(option.get(plain), ddt::default_text(option, filter));
            // No other option follows, but for those whose unit is the cost's.
            for (const ddt::Option& other : ddt::option_table())
                if (&other != &option && !other.holds) {
                    EXPECT_EQ(other.get(options), other.get(plain)) << option.key << other.key;
                }
            ASSERT_TRUE(ddt::check_options(options, error)) << error;
            ASSERT_TRUE(ddt::set_option(std::string(option.key) + "=" + value, plain, error));
            EXPECT_EQ(option.get(plain), value);
        }
    }
}

TEST(Options, EveryNamedValueIsOneAndItsOwn) {
    for (const ddt::Option& option : ddt::option_table())
        for (const ddt::NamedValue& value : option.values) {
            ddt::FilterOptions options;
            ASSERT_TRUE(option.set(options, value.name)) << option.key << "=" << value.name;
            EXPECT_EQ(option.get(options), value.name);
            EXPECT_NE(std::string(value.help), "");
        }
}

TEST(Options, HelpTellsFromWhichSizesAGpuIsTaken) {
    const std::string help = ddt::find_option("device")->values[0].help;
    EXPECT_NE(help.find("for each CPU thread " + std::to_string(ddt::worth_using) +
                        " source pixels, or " + std::to_string(ddt::worth_opening) + " ("),
              std::string::npos);
}

TEST(Options, KeysReachTheFieldsTheyName) {
    ddt::FilterOptions options;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt,cost=scf,iterations=7,light=ACEScg,meshes=3,min_gain=0.25,"
                                  "scheme=exproi3-maxgain,seed=9,start=diagonal,blur=0.125,"
                                  "clipped=1,consistency=5,device=cpu,limit=2,soft=0.75",
                                  options, error))
        << error;
    EXPECT_EQ(options.mesh.cost, ddt::Cost::scf);
    EXPECT_EQ(options.mesh.max_iterations, 7);
    EXPECT_EQ(options.light, "ACEScg");
    EXPECT_EQ(options.mesh.meshes, 3);
    EXPECT_EQ(options.mesh.min_gain, 0.25f);
    EXPECT_EQ(options.mesh.scheme, ddt::Scheme::exproi_n_maxgain);
    EXPECT_EQ(options.mesh.wide_iterations, 3);
    EXPECT_EQ(options.mesh.seed, 9u);
    EXPECT_EQ(options.mesh.start, ddt::Start::diagonal);
    EXPECT_EQ(options.mesh.blur, 0.125f);
    EXPECT_TRUE(options.surface.clipped);
    EXPECT_EQ(options.surface.consistency, 5);
    EXPECT_EQ(options.device, ddt::Device::cpu);
    EXPECT_EQ(options.surface.limit, 2.0f);
    EXPECT_EQ(options.surface.soft, 0.75f);
}

TEST(Options, DefaultsAreTheFirstFilter) {
    const ddt::FilterOptions plain;
    for (const ddt::Option& option : ddt::option_table())
        EXPECT_EQ(option.get(plain), ddt::default_text(option, "ddt")) << option.key;
    EXPECT_EQ(plain.surface.kind, ddt::Surface::patch);
}

TEST(Options, UnitsOfACostAreNotTakenForAnothers) {
    ddt::FilterOptions o;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt,cost=scf", o, error));
    EXPECT_LT(o.mesh.min_gain, 0.0f);
    EXPECT_EQ(o.surface.soft, 0.0f);
    ASSERT_TRUE(ddt::parse_filter("ddt-sharp,scheme=lawson", o, error));
    EXPECT_LT(o.mesh.min_gain, 0.0f);
    EXPECT_EQ(o.surface.soft, 0.3f);
    ASSERT_TRUE(ddt::parse_filter("ddt,cost=scf,soft=0.2,min_gain=0.01", o, error));
    EXPECT_EQ(o.mesh.min_gain, 0.01f);
    EXPECT_EQ(o.surface.soft, 0.2f);
    ASSERT_TRUE(ddt::parse_filter("ddt,min_gain=auto", o, error));
    EXPECT_LT(o.mesh.min_gain, 0.0f);
}

TEST(Options, OnlyNegativeNumbersHaveTheirName) {
    const ddt::Option& option = *ddt::find_option("min_gain");
    ddt::FilterOptions options;
    ASSERT_TRUE(option.set(options, "-0"));
    EXPECT_EQ(option.get(options), "-0");
    options.mesh.min_gain = -1;
    EXPECT_EQ(option.get(options), "auto");
    std::string error;
    for (const float nan : {std::nanf(""), -std::nanf("")}) {
        options.mesh.min_gain = nan;
        EXPECT_FALSE(ddt::check_options(options, error));
    }
}

TEST(Options, ParsedAlikeHoweverTheHostRounds) {
    ddt::FilterOptions usual, other;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt-sharp,soft=0.1", usual, error)) << error;
    std::string usual_refusal, refusal;
    EXPECT_FALSE(ddt::parse_filter("ddt,limit=1e50", other, usual_refusal));
    for (const ddt::test::HostMode& mode : ddt::test::host_modes()) {
        bool parsed = false, no_number = false, checked = false;
        {
            const ddt::test::HostFloats host(mode);
            parsed = ddt::parse_filter("ddt-sharp,soft=0.1", other, error);
            ddt::FilterOptions scratch;
            no_number = ddt::parse_filter("ddt,limit=nan", scratch, error);
            scratch.mesh.blur = std::numeric_limits<float>::quiet_NaN();
            checked = ddt::check_options(scratch, error);
            ddt::parse_filter("ddt,limit=1e50", scratch, refusal);
        }
        ASSERT_TRUE(parsed);
        EXPECT_FALSE(no_number);
        EXPECT_FALSE(checked);
        EXPECT_EQ(refusal, usual_refusal);
        EXPECT_EQ(other.surface.soft, 0.1f);
        EXPECT_EQ(other.mesh.blur, usual.mesh.blur);
        EXPECT_EQ(other.mesh.contour, usual.mesh.contour);
    }
}

TEST(Options, SubnormalNumbersAreRefused) {
    // Also in a thread to which they are 0.
    const ddt::DenormalsAreZero mode;
    for (const ddt::Option& option : ddt::option_table()) {
        if (option.kind != ddt::OptionKind::real)
            continue;
        const std::string key = option.key;
        for (const char* value : {"5e-39", "1e-45"})
            EXPECT_NE(error_of(("ddt," + key + "=" + value).c_str()).find("below"),
                      std::string::npos)
                << key;
        ddt::FilterOptions options;
        EXPECT_TRUE(option.set(options, "2e-38"));
        EXPECT_TRUE(option.set(options, "0"));
    }
    ddt::FilterOptions options;
    options.surface.soft = 5e-39f;
    std::string error;
    EXPECT_FALSE(ddt::check_options(options, error));
    EXPECT_NE(error.find("soft="), std::string::npos) << error;
}

TEST(Options, OnlyOfNumbersThatAreTooSmallIsItSaidThatTheyAre) {
    for (const char* value : {"1e-400", "1e-46", "-1e-400", "0.1e-5000"})
        EXPECT_NE(error_of((std::string("ddt,soft=") + value).c_str()).find("none but 0 below"),
                  std::string::npos)
            << value;
    for (const char* value : {"1e400", "1e39", "-1e400", "10e5000"}) {
        const std::string error = error_of((std::string("ddt,soft=") + value).c_str());
        EXPECT_NE(error.find(ddt::find_option("soft")->allowed()), std::string::npos) << error;
        EXPECT_EQ(error.find("below"), std::string::npos) << error;
    }
}

TEST(Options, FieldsOutOfRangeAreRefusedWithTheLineOfTheKey) {
    ddt::FilterOptions options;
    const auto refused = [&](const char* key) {
        std::string error;
        EXPECT_FALSE(ddt::check_options(options, error));
        EXPECT_EQ(error.rfind("ddt: option \"" + std::string(key) + "=", 0), 0u) << error;
        EXPECT_NE(error.find(ddt::find_option(key)->allowed()), std::string::npos) << error;
        options = {};
    };
    options.mesh.blur = ddt::largest_blur * 1.01f;
    refused("blur");
    options.surface.limit = std::nanf("");
    refused("limit");
    options.surface.consistency = ddt::most_consistency + 1;
    refused("consistency");
    options.mesh.cost = ddt::Cost(99);
    refused("cost");
    options.mesh.scheme = ddt::Scheme(99);
    refused("scheme");
    options.mesh.scheme = ddt::Scheme::exproi_n_maxgain;
    options.mesh.wide_iterations = 0;
    refused("scheme");
    options.device = ddt::Device(7);
    refused("device");
    options.light = ""; // it stands between commas
    refused("light");
    options.light = "sRGB,cost=scf";
    refused("light");
}

/// The texts of all options.
std::vector<std::string> all_values(const ddt::FilterOptions& options) {
    std::vector<std::string> values;
    for (const ddt::Option& option : ddt::option_table())
        values.push_back(option.get(options));
    return values;
}

TEST(Options, WhatIsNotAllowedIsNotSet) {
    for (const ddt::Option& option : ddt::option_table()) {
        std::vector<std::string> refused = {"", "no,such", ","};
        if (option.kind != ddt::OptionKind::text)
            for (const char* value : {"no such", "-1", " 1", "1x", "exproi0-maxgain", "nan"})
                refused.emplace_back(value);
        if (option.kind == ddt::OptionKind::toggle || option.kind == ddt::OptionKind::whole)
            refused.push_back(std::to_string(int64_t(option.high) + 1));
        if (option.kind == ddt::OptionKind::real)
            refused.push_back(ddt::number_text(float(option.high) * 1.5f));
        for (const std::string& value : refused) {
            SCOPED_TRACE(std::string(option.key) + "=" + value);
            ddt::FilterOptions options; // not the defaults: setting these would be seen too
            for (const ddt::Option& other : ddt::option_table())
                ASSERT_TRUE(other.set(options, other_value(other)));
            const std::vector<std::string> before = all_values(options);
            EXPECT_FALSE(option.set(options, value));
            EXPECT_EQ(all_values(options), before);
            std::string error;
            EXPECT_FALSE(ddt::set_option(std::string(option.key) + "=" + value, options, error));
            EXPECT_EQ(error.rfind("ddt: option \"" + std::string(option.key) + "=", 0), 0u)
                << error;
            EXPECT_NE(error.find(option.allowed()), std::string::npos) << error;
            EXPECT_EQ(error.find('\n'), std::string::npos) << error;
            EXPECT_EQ(all_values(options), before);
        }
    }
    for (const char* item : {"colour=red", "cost", "", "=abn"}) {
        ddt::FilterOptions options;
        std::string error;
        EXPECT_FALSE(ddt::set_option(item, options, error)) << item;
        EXPECT_EQ(error.rfind("ddt: ", 0), 0u) << error;
        EXPECT_EQ(all_values(options), all_values({})) << item;
    }
}

TEST(Options, KeysAndFiltersThatThereAreNot) {
    for (const char* key : {"", "colour", "cos", "costs", "Cost", "cost="})
        EXPECT_EQ(ddt::find_option(key), nullptr) << key;
    for (const ddt::Option& option : ddt::option_table())
        EXPECT_EQ(ddt::find_option(option.key), &option);
    std::vector<std::string> helps = {""};
    for (const std::string& filter : ddt::filter_names()) {
        const std::string help = ddt::filter_help(filter);
        EXPECT_EQ(std::count(helps.begin(), helps.end(), help), 0) << filter;
        helps.push_back(help);
    }
    for (const char* name : {"", "lanczos3", "ddtx", "ddt,cost=abn"})
        EXPECT_EQ(ddt::filter_help(name), "") << name;
}

TEST(Options, NumbersAreTextsThatGiveThemBack) {
    EXPECT_EQ(ddt::number_text(0.07f), "0.07");
    EXPECT_EQ(ddt::number_text(1e6f), "1000000");
    EXPECT_EQ(ddt::number_text(0), "0");
    EXPECT_EQ(ddt::number_text(1.5e-5f), "1.5e-05");
    EXPECT_EQ(ddt::number_text(1e-40f), "subnormal");
    EXPECT_EQ(ddt::number_text(-1e-40f), "subnormal");
    EXPECT_EQ(ddt::number_text(std::numeric_limits<float>::min()), "1.1754944e-38");
}

TEST(Options, SpacesWithinNames) {
    ddt::FilterOptions options;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt,light=Utility - sRGB - Texture", options, error));
    EXPECT_EQ(options.light, "Utility - sRGB - Texture");
}

TEST(Options, UnknownKeyIsNamedAndKeysListed) {
    const std::string error = error_of("ddt,colour=red");
    EXPECT_NE(error.find("\"colour\""), std::string::npos) << error;
    for (const char* key : {"cost", "iterations", "light", "min_gain", "scheme", "seed", "start"})
        EXPECT_NE(error.find(key), std::string::npos) << error;
}

TEST(Options, WrongValueIsNamedAndValuesListed) {
    const std::string error = error_of("ddt,cost=cheap");
    EXPECT_NE(error.find("\"cost=cheap\""), std::string::npos) << error;
    EXPECT_NE(error.find("abn, scf"), std::string::npos) << error;
    const std::string range = error_of("ddt,iterations=251");
    EXPECT_NE(range.find("from 0 to 250"), std::string::npos) << range;
    for (const char* spec : {"ddt,meshes=0", "ddt,meshes=5"})
        EXPECT_NE(error_of(spec).find("whole numbers from 1 to 4"), std::string::npos);
}

TEST(Options, MalformedOnesAreErrors) {
    for (const char* spec :
         {"ddt,", "ddt,,cost=abn", "ddt,cost", "ddt,cost=", "ddt,light=", "ddt,=abn",
          "ddt,iterations=1.5", "ddt,iterations=-1", "ddt,iterations=9999999999999",
          "ddt,min_gain=x", "ddt,min_gain=-1", "ddt,min_gain=nan", "ddt,min_gain=1e9",
          "ddt,min_gain=0.5x", "ddt, cost=abn", "lanczos3", "", "ddt-sharper"})
        EXPECT_NE(error_of(spec), "") << spec;
}

TEST(Options, WhatIsNotNamedIsTheFilters) {
    ddt::FilterOptions options;
    options.light = "encoded";
    options.mesh.seed = 5;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt-linear", options, error));
    EXPECT_EQ(options.light, "auto");
    EXPECT_EQ(options.mesh.seed, 1u);
}

TEST(Options, FailureChangesNothing) {
    ddt::FilterOptions options;
    options.light = "kept";
    std::string error;
    EXPECT_FALSE(ddt::parse_filter("ddt-linear,light=encoded,cost=scf,bad=1", options, error));
    EXPECT_EQ(options.light, "kept");
    EXPECT_EQ(options.mesh.cost, ddt::Cost::abn);
    EXPECT_EQ(options.surface.kind, ddt::Surface::patch);
}

TEST(Options, ContoursCountWithTheFiltersOwnCostAndSchemeOnly) {
    const auto contour = [](const char* spec) {
        ddt::FilterOptions options;
        std::string error;
        EXPECT_TRUE(ddt::parse_filter(spec, options, error)) << error;
        return options.mesh.contour;
    };
    EXPECT_GT(contour("ddt"), 0.0f);
    EXPECT_EQ(contour("ddt,contour=0"), 0.0f);
    EXPECT_EQ(contour("ddt,contour=0.5"), 0.5f);
    EXPECT_EQ(contour("ddt,cost=scf"), 0.0f);
    EXPECT_EQ(contour("ddt,scheme=exproi"), 0.0f);
    EXPECT_EQ(contour("ddt,scheme=exproi,contour=0.5"), 0.5f);
}

TEST(Options, TheSharpFilterIsFittedWhereItIsClippedAndUnlessToldOtherwise) {
    const auto fitted = [](const char* spec) {
        ddt::FilterOptions options;
        std::string error;
        EXPECT_TRUE(ddt::parse_filter(spec, options, error)) << error;
        return options.surface.fitted;
    };
    EXPECT_TRUE(fitted("ddt-sharp,clipped=1"));
    EXPECT_FALSE(fitted("ddt-sharp,clipped=1,fitted=0"));
    EXPECT_FALSE(fitted("ddt-sharp"));
    EXPECT_TRUE(fitted("ddt-sharp,fitted=1"));
    EXPECT_FALSE(fitted("ddt-sharp,clipped=1,cost=scf"));
    EXPECT_FALSE(fitted("ddt-sharp,clipped=1,consistency=3"));
    EXPECT_FALSE(fitted("ddt,clipped=1"));
}

} // namespace
