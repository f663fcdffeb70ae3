// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/channels.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/plugin/image/named.h"

namespace {

using ddt::test::named;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

TEST(Channels, ColourByNameInAnyOrder) {
    const auto c = ddt::channels_of(named({"A", "B", "G", "R", "Z"}));
    EXPECT_EQ(c.colour.count, 3);
    EXPECT_EQ(c.colour.channel[0], 3);
    EXPECT_EQ(c.colour.channel[1], 2);
    EXPECT_EQ(c.colour.channel[2], 1);
    EXPECT_EQ(c.colour.alpha, 0);
    EXPECT_EQ(c.alpha, 0);
}

TEST(Channels, ColourIsTheFirstThreeWithoutNames) {
    EXPECT_EQ(ddt::channels_of(named({"m1", "m2", "m3", "m4"})).colour.count, 3);
    EXPECT_EQ(ddt::channels_of(named({"u", "A", "v"})).colour.count, 0);
    EXPECT_EQ(ddt::channels_of(named({"Z", "u", "v"})).colour.count, 0);
    EXPECT_EQ(ddt::channels_of(named({"objectId", "u", "v"})).colour.count, 0);
}

TEST(Channels, GreyIsColour) {
    const auto c = ddt::channels_of(named({"A", "Y"}));
    EXPECT_EQ(c.colour.count, 1);
    EXPECT_EQ(c.colour.channel[0], 1);
    EXPECT_EQ(c.colour.alpha, 0);
    EXPECT_EQ(ddt::channels_of(named({"height"})).colour.count, 1);
    EXPECT_EQ(ddt::channels_of(named({"u", "v"})).colour.count, 0);
    EXPECT_EQ(ddt::channels_of(named({"Z"})).colour.count, 0);
}

TEST(Channels, GuideWithoutNamesOfColour) {
    using Guide = std::vector<int>;
    const auto guide_of = [](std::vector<std::string> names) {
        return ddt::channels_of(named(std::move(names))).guide;
    };
    EXPECT_EQ(guide_of({"A", "id", "u", "v"}), (Guide{2, 3}));
    EXPECT_EQ(guide_of({"N.X", "N.Y", "N.Z"}), (Guide{0, 1, 2}));
    EXPECT_EQ(guide_of({"Z", "m1", "m2", "m3", "m4"}), (Guide{1, 2, 3}));
    EXPECT_EQ(guide_of({"A", "id"}), Guide{});
    EXPECT_EQ(guide_of({"Z"}), Guide{0});
    EXPECT_EQ(guide_of({"height"}), Guide{});
    EXPECT_EQ(guide_of({"Y", "A", "Z"}), Guide{});
    EXPECT_EQ(guide_of({"a.R", "a.G", "a.B"}), Guide{});
    EXPECT_EQ(guide_of({"C", "M", "Y", "K"}), (Guide{0, 1, 2, 3}));
    EXPECT_EQ(guide_of({"C", "K", "M", "Y", "gold"}), (Guide{0, 2, 3, 1}));
    EXPECT_EQ(guide_of({"Y", "C", "K", "M"}), (Guide{1, 3, 0, 2})); // as an EXR has them
    EXPECT_EQ(guide_of({"C", "M", "Y"}), (Guide{0, 1, 2}));
}

TEST(Channels, ShownAreColourOrTheGuide) {
    const auto shown = [](std::vector<std::string> names) {
        const auto layout = ddt::shown_colour(ddt::channels_of(named(std::move(names))));
        return std::vector<int>(layout.channel, layout.channel + layout.count);
    };
    EXPECT_EQ(shown({"A", "B", "G", "R"}), (std::vector<int>{3, 2, 1}));
    EXPECT_EQ(shown({"Z", "X", "Y"}), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(shown({"Z", "u", "v"}), std::vector<int>{1});
    EXPECT_EQ(shown({"C", "M", "Y", "K"}), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(shown({"id"}), std::vector<int>{});
}

TEST(Channels, UnassociatedAlphaIsNotDividedBy) {
    ImageSpec spec = named({"R", "G", "B", "A"});
    spec.attribute("oiio:UnassociatedAlpha", 1);
    EXPECT_EQ(ddt::channels_of(spec).colour.alpha, -1);
    EXPECT_EQ(ddt::channels_of(spec).alpha, 3);
}

TEST(Channels, AlphaThatIsNotThereIsFoundByItsName) {
    ImageSpec spec = named({"R", "G", "B", "A"});
    for (const auto& [said, found] : {std::pair(3, 3), {2, 2}, {-1, -1}, {4, 3}}) {
        spec.alpha_channel = said;
        EXPECT_EQ(ddt::alpha_of(spec), found) << said;
        EXPECT_EQ(ddt::channels_of(spec).alpha, found) << said;
    }
    spec.channelnames[3] = "mask";
    EXPECT_EQ(ddt::alpha_of(spec), -1);
}

// OpenImageIO's reader of TIFF takes the fourth channel for alpha.
TEST(Channels, BlackIsNoAlpha) {
    const auto alpha_of = [](std::vector<std::string> names, const char* space = "") {
        ImageSpec spec = named(std::move(names));
        spec.alpha_channel = 3;
        spec.attribute("oiio:ColorSpace", space);
        const auto channels = ddt::channels_of(spec);
        EXPECT_EQ(channels.alpha, ddt::alpha_of(spec));
        const auto& kinds = channels.kinds;
        EXPECT_EQ(std::count(kinds.begin(), kinds.end(), ddt::Channel::alpha), channels.alpha >= 0);
        return channels.alpha;
    };
    EXPECT_EQ(alpha_of({"C", "M", "Y", "K"}), -1);
    EXPECT_EQ(alpha_of({"cyan", "magenta", "yellow", "black", "A"}), 4);
    EXPECT_EQ(alpha_of({"1", "2", "3", "4"}, "CMYK"), -1);
    EXPECT_EQ(alpha_of({"1", "2", "3", "4"}), 3);
    EXPECT_EQ(alpha_of({"R", "G", "B", "A"}, "CMYK"), 3);
}

TEST(Channels, IntegersAreIds) {
    for (const auto type : {TypeDesc::UINT32, TypeDesc::INT32}) {
        const auto c = ddt::channels_of(named({"R", "G", "B"}, TypeDesc(type)));
        EXPECT_TRUE(c.raw);
        EXPECT_EQ(c.colour.count, 0);
        for (const auto kind : c.kinds)
            EXPECT_EQ(kind, ddt::Channel::nearest);
    }
    EXPECT_FALSE(ddt::channels_of(named({"R"}, OIIO::TypeUInt16)).raw);
}

TEST(Channels, SomeMayBeStoredAsIds) {
    ImageSpec native = named({"R", "G", "B", "thing"}, OIIO::TypeHalf);
    native.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeUInt32};
    const auto c = ddt::channels_of(named({"R", "G", "B", "thing"}), native);
    EXPECT_FALSE(c.raw);
    EXPECT_EQ(c.colour.count, 3);
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(c.kinds[i] == ddt::Channel::nearest, i == 3) << i;
}

TEST(Channels, Cryptomatte) {
    ImageSpec spec = named({"R", "G", "B", "matte.R", "matte00.R", "matte01.A", "matte000",
                            "CryptoObject00.G", "CryptoObject.R"});
    spec.attribute("cryptomatte/1a2b3c/name", "matte");
    const auto c = ddt::channels_of(spec);
    const std::vector<int> ids{4, 5, 7};
    for (int i = 0; i < spec.nchannels; ++i)
        EXPECT_EQ(c.kinds[size_t(i)] == ddt::Channel::nearest,
                  std::find(ids.begin(), ids.end(), i) != ids.end())
            << spec.channelnames[size_t(i)];
}

TEST(Channels, IdsThatAreALayerOfOneChannel) {
    const ImageSpec spec =
        named({"R", "G", "B", "objectID.red", "matId.R", "matId.G", "matId.B", "View.IndexOB.X",
               "prim_id.Y", "View.objectId.Z", "View.IndexMA.X", "View.Index.X", "grid.R", "id.x",
               "shadow.id.r", "id", "david.A", "astrid.mask", "View.Object Index.X"});
    const std::vector<int> ids{3, 7, 8, 9, 10, 13, 14, 15, 18};
    const auto c = ddt::channels_of(spec);
    for (int i = 0; i < spec.nchannels; ++i)
        EXPECT_EQ(c.kinds[size_t(i)] == ddt::Channel::nearest,
                  std::find(ids.begin(), ids.end(), i) != ids.end())
            << spec.channelnames[size_t(i)];
}

TEST(Channels, IdsOfALayerOrAPart) {
    const auto nearest = [](ImageSpec spec, const char* part, const char* matte) {
        if (*part)
            spec.attribute("oiio:subimagename", part);
        if (*matte)
            spec.attribute("cryptomatte/1a2b3c/name", matte);
        const auto kinds = ddt::channels_of(spec).kinds;
        return std::count(kinds.begin(), kinds.end(), ddt::Channel::nearest);
    };
    const ImageSpec colour = named({"R", "G", "B", "A"});
    EXPECT_EQ(nearest(colour, "crypto_object00", ""), 4);
    EXPECT_EQ(nearest(colour, "matte01", "matte"), 4);
    EXPECT_EQ(nearest(colour, "rgba", "matte"), 0);
    EXPECT_EQ(nearest(colour, "matte", "matte"), 0);
    EXPECT_EQ(nearest(colour, "", "matte"), 0);
    EXPECT_EQ(nearest(named({"X"}), "objectId", ""), 1);
    EXPECT_EQ(nearest(named({"X"}), "grid", ""), 0);
    EXPECT_EQ(nearest(colour, "objectId", ""), 0);
    const ImageSpec layers = named({"View.CryptoObject00.r", "View.Sub.CryptoMaterial02.A",
                                    "View.Crypto.R", "View.Combined.R"});
    EXPECT_EQ(nearest(layers, "", ""), 2);
}

} // namespace
