// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/base/float_mode.h"
#include "ddt/core.h"
#include "ddt/option_table.h"
#include "tests/core/host_floats.h"

namespace ddt::test {
namespace {

std::string error_of(const char* spec) {
    FilterOptions options;
    std::string error;
    EXPECT_FALSE(parse_filter(spec, options, error)) << spec;
    EXPECT_EQ(error.find('\n'), std::string::npos);
    return error;
}

TEST(ParseFilter, ErrorsHoldNothingThatATerminalObeys) {
    for (const std::string name : {"\x9B"
                                   "31m",
                                   "\xC2\x9B"
                                   "31m",
                                   "\033[31m", "\n31m", "\x7F"}) {
        for (const std::string& spec : {name, "ddt," + name + "=1", "ddt,seed=" + name}) {
            const std::string error = error_of(spec.c_str());
            EXPECT_EQ(error.find(name), std::string::npos) << spec;
            EXPECT_NE(error.find('?'), std::string::npos) << error;
        }
    }
}

TEST(ParseFilter, NameSetsSurface) {
    FilterOptions options;
    std::string error;
    ASSERT_TRUE(parse_filter("ddt-linear", options, error));
    EXPECT_EQ(options.surface.kind, Surface::linear);
    ASSERT_TRUE(parse_filter("ddt", options, error));
    EXPECT_EQ(options.surface.kind, Surface::patch);
}

TEST(ParseFilter, KeysReachTheFieldsTheyName) {
    FilterOptions options;
    std::string error;
    ASSERT_TRUE(parse_filter("ddt,cost=scf,iterations=7,light=ACEScg,meshes=3,min_gain=0.25,"
                             "scheme=exproi3-maxgain,seed=9,start=diagonal,blur=0.125,"
                             "clipped=1,consistency=5,device=cpu,limit=2,soft=0.75",
                             options, error))
        << error;
    EXPECT_EQ(options.mesh.cost, Cost::scf);
    EXPECT_EQ(options.mesh.max_iterations, 7);
    EXPECT_EQ(options.light, "ACEScg");
    EXPECT_EQ(options.mesh.meshes, 3);
    EXPECT_EQ(options.mesh.min_gain, 0.25f);
    EXPECT_EQ(options.mesh.scheme, Scheme::exproi_n_maxgain);
    EXPECT_EQ(options.mesh.wide_iterations, 3);
    EXPECT_EQ(options.mesh.seed, 9u);
    EXPECT_EQ(options.mesh.start, Start::diagonal);
    EXPECT_EQ(options.mesh.blur, 0.125f);
    EXPECT_TRUE(options.surface.clipped);
    EXPECT_EQ(options.surface.consistency, 5);
    EXPECT_EQ(options.device, Device::cpu);
    EXPECT_EQ(options.surface.limit, 2.0f);
    EXPECT_EQ(options.surface.soft, 0.75f);
}

TEST(ParseFilter, UnitsOfACostAreNotTakenForAnothers) {
    FilterOptions o;
    std::string error;
    ASSERT_TRUE(parse_filter("ddt,cost=scf", o, error));
    EXPECT_LT(o.mesh.min_gain, 0.0f);
    EXPECT_EQ(o.surface.soft, 0.0f);
    ASSERT_TRUE(parse_filter("ddt-sharp,scheme=lawson", o, error));
    EXPECT_LT(o.mesh.min_gain, 0.0f);
    EXPECT_EQ(o.surface.soft, 0.3f);
    ASSERT_TRUE(parse_filter("ddt,cost=scf,soft=0.2,min_gain=0.01", o, error));
    EXPECT_EQ(o.mesh.min_gain, 0.01f);
    EXPECT_EQ(o.surface.soft, 0.2f);
    ASSERT_TRUE(parse_filter("ddt,min_gain=auto", o, error));
    EXPECT_LT(o.mesh.min_gain, 0.0f);
}

TEST(ParseFilter, ParsedAlikeHoweverTheHostRounds) {
    FilterOptions usual, other;
    std::string error;
    ASSERT_TRUE(parse_filter("ddt-sharp,soft=0.1", usual, error)) << error;
    std::string usual_refusal, refusal;
    EXPECT_FALSE(parse_filter("ddt,limit=1e50", other, usual_refusal));
    for (const HostMode& mode : host_modes()) {
        bool parsed = false, no_number = false, checked = false;
        {
            const HostFloats host(mode);
            parsed = parse_filter("ddt-sharp,soft=0.1", other, error);
            FilterOptions scratch;
            no_number = parse_filter("ddt,limit=nan", scratch, error);
            scratch.mesh.blur = std::numeric_limits<float>::quiet_NaN();
            checked = check_options(scratch, error);
            parse_filter("ddt,limit=1e50", scratch, refusal);
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

TEST(ParseFilter, SubnormalNumbersAreRefused) {
    // Also in a thread to which they are 0.
    const DenormalsAreZero mode;
    for (const Option& option : option_table()) {
        if (option.kind != OptionKind::real)
            continue;
        const std::string key = option.key;
        for (const char* value : {"5e-39", "1e-45"})
            EXPECT_NE(error_of(("ddt," + key + "=" + value).c_str()).find("below"),
                      std::string::npos)
                << key;
        FilterOptions options;
        EXPECT_TRUE(option.set(options, "2e-38"));
        EXPECT_TRUE(option.set(options, "0"));
    }
    FilterOptions options;
    options.surface.soft = 5e-39f;
    std::string error;
    EXPECT_FALSE(check_options(options, error));
    EXPECT_NE(error.find("soft="), std::string::npos) << error;
}

TEST(ParseFilter, OnlyOfNumbersThatAreTooSmallIsItSaidThatTheyAre) {
    for (const char* value : {"1e-400", "1e-46", "-1e-400", "0.1e-5000"})
        EXPECT_NE(error_of((std::string("ddt,soft=") + value).c_str()).find("none but 0 below"),
                  std::string::npos)
            << value;
    for (const char* value : {"1e400", "1e39", "-1e400", "10e5000"}) {
        const std::string error = error_of((std::string("ddt,soft=") + value).c_str());
        EXPECT_NE(error.find(find_option("soft")->allowed()), std::string::npos) << error;
        EXPECT_EQ(error.find("below"), std::string::npos) << error;
    }
}

TEST(ParseFilter, FieldsOutOfRangeAreRefusedWithTheLineOfTheKey) {
    FilterOptions options;
    const auto refused = [&](const char* key) {
        std::string error;
        EXPECT_FALSE(check_options(options, error));
        EXPECT_EQ(error.rfind("ddt: option \"" + std::string(key) + "=", 0), 0u) << error;
        EXPECT_NE(error.find(find_option(key)->allowed()), std::string::npos) << error;
        options = {};
    };
    options.mesh.blur = largest_blur * 1.01f;
    refused("blur");
    options.surface.limit = std::nanf("");
    refused("limit");
    options.surface.consistency = most_consistency + 1;
    refused("consistency");
    options.mesh.cost = Cost(99);
    refused("cost");
    options.mesh.scheme = Scheme(99);
    refused("scheme");
    options.mesh.scheme = Scheme::exproi_n_maxgain;
    options.mesh.wide_iterations = 0;
    refused("scheme");
    options.device = Device(7);
    refused("device");
    options.light = ""; // it stands between commas
    refused("light");
    options.light = "sRGB,cost=scf";
    refused("light");
}

TEST(ParseFilter, SpacesWithinNames) {
    FilterOptions options;
    std::string error;
    ASSERT_TRUE(parse_filter("ddt,light=Utility - sRGB - Texture", options, error));
    EXPECT_EQ(options.light, "Utility - sRGB - Texture");
}

TEST(ParseFilter, UnknownKeyIsNamedAndKeysListed) {
    const std::string error = error_of("ddt,colour=red");
    EXPECT_NE(error.find("\"colour\""), std::string::npos) << error;
    for (const char* key : {"cost", "iterations", "light", "min_gain", "scheme", "seed", "start"})
        EXPECT_NE(error.find(key), std::string::npos) << error;
}

TEST(ParseFilter, WrongValueIsNamedAndValuesListed) {
    const std::string error = error_of("ddt,cost=cheap");
    EXPECT_NE(error.find("\"cost=cheap\""), std::string::npos) << error;
    EXPECT_NE(error.find("abn, scf"), std::string::npos) << error;
    const std::string range = error_of("ddt,iterations=401");
    EXPECT_NE(range.find("from 0 to 400"), std::string::npos) << range;
    for (const char* spec : {"ddt,meshes=0", "ddt,meshes=5"})
        EXPECT_NE(error_of(spec).find("whole numbers from 1 to 4"), std::string::npos);
}

TEST(ParseFilter, MalformedOnesAreErrors) {
    for (const char* spec :
         {"ddt,", "ddt,,cost=abn", "ddt,cost", "ddt,cost=", "ddt,light=", "ddt,=abn",
          "ddt,iterations=1.5", "ddt,iterations=-1", "ddt,iterations=9999999999999",
          "ddt,min_gain=x", "ddt,min_gain=-1", "ddt,min_gain=nan", "ddt,min_gain=1e9",
          "ddt,min_gain=0.5x", "ddt, cost=abn", "lanczos3", "", "ddt-sharper"})
        EXPECT_NE(error_of(spec), "") << spec;
}

TEST(ParseFilter, WhatIsNotNamedIsTheFilters) {
    FilterOptions options;
    options.light = "encoded";
    options.mesh.seed = 5;
    std::string error;
    ASSERT_TRUE(parse_filter("ddt-linear", options, error));
    EXPECT_EQ(options.light, "auto");
    EXPECT_EQ(options.mesh.seed, 1u);
}

TEST(ParseFilter, FailureChangesNothing) {
    FilterOptions options;
    options.light = "kept";
    std::string error;
    EXPECT_FALSE(parse_filter("ddt-linear,light=encoded,cost=scf,bad=1", options, error));
    EXPECT_EQ(options.light, "kept");
    EXPECT_EQ(options.mesh.cost, Cost::abn);
    EXPECT_EQ(options.surface.kind, Surface::patch);
}

TEST(ParseFilter, ContoursCountWithTheFiltersOwnCostAndSchemeOnly) {
    const auto contour = [](const char* spec) {
        FilterOptions options;
        std::string error;
        EXPECT_TRUE(parse_filter(spec, options, error)) << error;
        return options.mesh.contour;
    };
    EXPECT_GT(contour("ddt"), 0.0f);
    EXPECT_EQ(contour("ddt,contour=0"), 0.0f);
    EXPECT_EQ(contour("ddt,contour=0.5"), 0.5f);
    EXPECT_EQ(contour("ddt,cost=scf"), 0.0f);
    EXPECT_EQ(contour("ddt,scheme=exproi"), 0.0f);
    EXPECT_EQ(contour("ddt,scheme=exproi,contour=0.5"), 0.5f);
}

TEST(ParseFilter, TheSharpFilterIsFittedWhereItIsClippedAndUnlessToldOtherwise) {
    const auto fitted = [](const char* spec) {
        FilterOptions options;
        std::string error;
        EXPECT_TRUE(parse_filter(spec, options, error)) << error;
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
} // namespace ddt::test
