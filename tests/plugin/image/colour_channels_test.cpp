// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/colour_channels.h"

#include <gtest/gtest.h>

#include "plugin/image/channels.h"
#include "tests/plugin/image/named.h"

namespace {

using ddt::test::named;

/// The names of colour's channels, then of its alpha, with spaces.
std::string colour_of(const OIIO::ImageSpec& spec) {
    const ddt::Channels channels = ddt::channels_of(spec);
    std::string names;
    for (int k = 0; k < channels.colour.count; ++k)
        names += spec.channelnames[size_t(channels.colour.channel[k])] + ' ';
    return names + (channels.alpha < 0 ? "-" : spec.channelnames[size_t(channels.alpha)]);
}

/// Names of the channels of a layer, one letter a component.
std::vector<std::string> layer_of(const std::string& name, const std::string& components) {
    std::vector<std::string> names;
    for (const char component : components)
        names.push_back(name + '.' + component);
    return names;
}

OIIO::ImageSpec image_of(const std::vector<std::vector<std::string>>& all) {
    std::vector<std::string> names;
    for (const auto& some : all)
        names.insert(names.end(), some.begin(), some.end());
    return named(names);
}

TEST(ColourChannels, AreThePicturesAmongLayers) {
    const std::string combined = "View.Combined.R View.Combined.G View.Combined.B ";
    EXPECT_EQ(colour_of(image_of({layer_of("View.AO", "RGB"), layer_of("View.Combined", "RGBA")})),
              combined + "View.Combined.A");
    EXPECT_EQ(colour_of(image_of({{"View.Depth.Z"}, layer_of("View.Combined", "RGBA")})),
              combined + "View.Combined.A");
    EXPECT_EQ(
        colour_of(image_of({layer_of("CryptoObject00", "RGBA"), layer_of("View.Combined", "RGB")})),
        combined + "-");
    EXPECT_EQ(colour_of(image_of({layer_of("N", "XYZ"), layer_of("View.Combined", "BGR")})),
              combined + "-");
    EXPECT_EQ(colour_of(named({"N.red", "N.green", "N.blue", "Beauty.blue", "Beauty.green",
                               "Beauty.red", "Beauty.alpha"})),
              "Beauty.red Beauty.green Beauty.blue -"); // whose spec has no alpha
}

TEST(ColourChannels, AreBareOnesBeforeAnyLayers) {
    EXPECT_EQ(colour_of(image_of({layer_of("rgba", "RGBA"), {"blue", "green", "red"}})),
              "red green blue -");
}

TEST(ColourChannels, AreOfTheFirstLayerOfTheLikeliestName) {
    EXPECT_EQ(colour_of(image_of({layer_of("a", "RGB"), layer_of("b", "RGB")})), "a.R a.G a.B -");
    EXPECT_EQ(colour_of(image_of({layer_of("main", "RGB"), layer_of("mattes", "RGBA")})),
              "main.R main.G main.B -");
    EXPECT_EQ(colour_of(image_of({layer_of("depth", "RGB"), layer_of("b", "RGB")})),
              "b.R b.G b.B -");
    EXPECT_EQ(colour_of(image_of({layer_of("depth", "RGB")})), "depth.R depth.G depth.B -");
    EXPECT_EQ(colour_of(image_of({layer_of("a", "RGBA"), layer_of("rgb.left", "RGB")})),
              "rgb.left.R rgb.left.G rgb.left.B -");
    EXPECT_EQ(colour_of(image_of({layer_of("C.left", "RGB"), layer_of("C", "RGB")})),
              "C.R C.G C.B -");
    EXPECT_EQ(colour_of(image_of({layer_of("a", "RG"), layer_of("b", "RGB")})), "b.R b.G b.B -");
}

TEST(ColourChannels, AreGreyBeforeALayers) {
    EXPECT_EQ(colour_of(image_of({{"Y", "A"}, layer_of("mask", "RGBA")})), "Y A");
    EXPECT_EQ(colour_of(image_of({layer_of("mask", "RGB"), {"Y", "Z"}})), "Y -");
    EXPECT_EQ(colour_of(named({"Y", "BY", "RY"})), "Y -");
}

TEST(ColourChannels, AloneAreWhereEdgesAreSought) {
    const ddt::Channels channels = ddt::channels_of(image_of({{"height"}, layer_of("P", "XYZ")}));
    EXPECT_EQ(channels.colour.count, 1);
    EXPECT_TRUE(channels.guide.empty());
}

TEST(ColourChannels, HaveTheAlphaOfNoOtherColour) {
    EXPECT_EQ(colour_of(image_of({layer_of("AO", "RGBA"), layer_of("C", "RGBA")})),
              "C.R C.G C.B C.A");
    EXPECT_EQ(colour_of(image_of({layer_of("AO", "RGBA"), layer_of("C", "RGB")})), "C.R C.G C.B -");
    EXPECT_EQ(colour_of(image_of({layer_of("C", "RGB"), {"A"}})), "C.R C.G C.B A");
    EXPECT_EQ(colour_of(image_of({layer_of("C", "RGB"), {"cover.A"}})), "C.R C.G C.B cover.A");
}

TEST(ColourChannels, AreNoVectors) {
    for (const auto& names : {std::vector<std::string>{"X", "Y", "Z"},
                              {"N.X", "N.Y", "N.Z"},
                              {"X", "Y"},
                              {"u", "v", "w"}})
        EXPECT_EQ(colour_of(named(names)), "-") << names.front();
    EXPECT_EQ(colour_of(named({"N.X", "N.Y", "Y"})), "Y -");
}

// maketx --bumpslopes enlarges them with the colour space of the picture that they were made of,
// and with its alpha.
TEST(ColourChannels, AreNoSlopes) {
    OIIO::ImageSpec spec =
        named({"b0_h", "b1_dhds", "b2_dhdt", "b3_dhds2", "b4_dhdt2", "b5_dh2dsdt"});
    spec.alpha_channel = 3;
    EXPECT_EQ(colour_of(spec), "-");
    EXPECT_EQ(ddt::channels_of(spec).guide, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(colour_of(named({"b0_h"})), "-");
}

TEST(ColourChannels, AreNoInks) {
    EXPECT_EQ(colour_of(named({"C", "M", "Y", "K"})), "-");
    EXPECT_EQ(colour_of(named({"C", "M", "Y", "K", "A"})), "A");
    EXPECT_EQ(colour_of(named({"C", "M", "Y", "K", "gold"})), "-");
    EXPECT_EQ(colour_of(named({"C", "Y"})), "Y -");
    EXPECT_EQ(colour_of(image_of({{"R", "G", "B"}, layer_of("plate", "CMYK")})), "R G B -");
    OIIO::ImageSpec unnamed = named({"1", "2", "3", "4"});
    EXPECT_EQ(colour_of(unnamed), "1 2 3 -");
    unnamed.attribute("oiio:ColorSpace", "CMYK");
    EXPECT_EQ(colour_of(unnamed), "-");
}

TEST(ColourChannels, DepthIsNoPartOfAVector) {
    const auto quantities = [](const std::vector<std::string>& names) {
        const OIIO::ImageSpec spec = named(names);
        return ddt::quantities_of(spec, ddt::layers_of(spec));
    };
    using ddt::Quantity;
    const std::vector<Quantity> vector(3, Quantity::vector);
    EXPECT_EQ(quantities({"X", "Y", "Z"}), vector);
    EXPECT_EQ(quantities({"N.X", "N.Y", "N.Z"}), vector);
    EXPECT_EQ(quantities({"u", "v", "W"}), vector);
    const std::vector<Quantity> depth(3, Quantity::depth);
    EXPECT_EQ(quantities({"Z", "back.Z", "View.Depth.V"}), depth);
    const std::vector<Quantity> other(3, Quantity::other);
    EXPECT_EQ(quantities({"X", "a.Y", "u"}), other);
}

} // namespace
