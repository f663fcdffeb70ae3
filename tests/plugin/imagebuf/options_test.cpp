// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ddt/resize.h"

namespace {

std::string error_of(const char* spec) {
    ddt::Options options;
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
    ddt::Options options;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt-linear", options, error));
    EXPECT_EQ(options.surface.kind, ddt::Surface::linear);
    ASSERT_TRUE(ddt::parse_filter("ddt", options, error));
    EXPECT_EQ(options.surface.kind, ddt::Surface::patch);
}

TEST(Options, NameStandsForWhatTheCoreSays) {
    for (const std::string& name : ddt::filter_names()) {
        ddt::Options options;
        ddt::SurfaceOptions surface;
        ddt::MeshOptions mesh;
        std::string error;
        ASSERT_TRUE(ddt::parse_filter(name, options, error)) << error;
        ASSERT_TRUE(ddt::set_filter(name, surface, mesh));
        EXPECT_EQ(options.surface.kind, surface.kind);
        EXPECT_EQ(options.surface.consistency, surface.consistency);
        EXPECT_EQ(options.surface.soft, surface.soft);
        EXPECT_EQ(options.mesh.min_gain, mesh.min_gain);
        EXPECT_EQ(options.mesh.blur, mesh.blur);
    }
}

TEST(Options, EveryKey) {
    ddt::Options options;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt,cost=scf,iterations=7,light=ACEScg,meshes=3,min_gain=0.25,"
                                  "scheme=exproi3-maxgain,seed=9,start=diagonal",
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
}

TEST(Options, SpacesWithinNames) {
    ddt::Options options;
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

TEST(Options, FailureChangesNothing) {
    ddt::Options options;
    options.light = "kept";
    std::string error;
    EXPECT_FALSE(ddt::parse_filter("ddt-linear,light=encoded,cost=scf,bad=1", options, error));
    EXPECT_EQ(options.light, "kept");
    EXPECT_EQ(options.mesh.cost, ddt::Cost::abn);
    EXPECT_EQ(options.surface.kind, ddt::Surface::patch);
}

} // namespace
