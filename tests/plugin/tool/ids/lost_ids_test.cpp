// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/ids/lost_ids.h"

#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "tests/temporary.h"

using namespace ddt::tool;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

namespace {

constexpr int side = 64;

ImageSpec spec_of(TypeDesc type, const std::vector<std::string>& names,
                  const std::string& compression) {
    ImageSpec spec(side, side, int(names.size()), type);
    spec.channelnames = names;
    spec.attribute("compression", compression);
    return spec;
}

const std::vector<std::string> names = {
    "CryptoObject00.R", "CryptoObject00.G", "CryptoObject00.B", "CryptoObject00.A", "id", "primId"};

/// Numbers of all bits that are none of a NaN.
template <class Number>
std::vector<Number> numbers(size_t n, Number below) {
    std::mt19937 random(1);
    std::uniform_int_distribution<Number> bits(0, below - 1);
    std::vector<Number> all(n);
    for (Number& number : all)
        number = bits(random);
    return all;
}

/// Which channels do not come back from an EXR file, as OpenEXR's C++ library reads it: its core of
/// 3.1, which OpenImageIO 2.5.19 reads by, mixes up several channels of floats or integers in B44.
std::string lost_in_truth(const ImageSpec& spec, const void* pixels) {
    int by_core = 0;
    OIIO::getattribute("openexr:core", by_core);
    OIIO::attribute("openexr:core", 0);
    const std::string path = ddt::temporary("lost.exr");
    const auto output = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(output->open(path, spec) && output->write_image(spec.format, pixels) &&
                output->close());
    std::string lost;
    for (int c = 0; c < spec.nchannels; ++c) {
        const auto input = OIIO::ImageInput::open(path);
        // Files sort their channels.
        const int stored = input->spec().channelindex(spec.channel_name(c));
        std::vector<char> read(spec.image_pixels() * spec.format.size());
        EXPECT_TRUE(input->read_image(0, 0, stored, stored + 1, spec.format, read.data()));
        const size_t size = spec.format.size(), pixel = size * size_t(spec.nchannels);
        for (size_t i = 0; i < spec.image_pixels(); ++i)
            if (std::memcmp(&read[i * size],
                            static_cast<const char*>(pixels) + i * pixel + size_t(c) * size,
                            size) != 0) {
                lost += (lost.empty() ? "" : ", ") + std::string(spec.channel_name(c));
                break;
            }
    }
    OIIO::attribute("openexr:core", by_core);
    return lost;
}

TEST(LostIds, AreThoseThatACompressionOfOpenExrRounds) {
    const size_t n = side * side * names.size();
    const auto halfs = numbers<uint16_t>(n, 30000);
    const auto floats = numbers<uint32_t>(n, 0x7f800000);
    const auto integers = numbers<uint32_t>(n, 0xffffffff);
    int lossy = 0;
    for (const char* compression :
         {"none", "rle", "zip", "zips", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"})
        for (const TypeDesc& type : {OIIO::TypeHalf, OIIO::TypeFloat, OIIO::TypeUInt32}) {
            const void* const pixels = type == OIIO::TypeHalf    ? (const void*)halfs.data()
                                       : type == OIIO::TypeFloat ? (const void*)floats.data()
                                                                 : integers.data();
            const ImageSpec written = spec_of(type, names, compression);
            const std::string truth = lost_in_truth(written, pixels);
            lossy += !truth.empty();
            const LostIds lost = lost_ids(spec_of(type, names, "none"), written);
            EXPECT_EQ(lost.by_compression, truth) << compression << ' ' << type;
            EXPECT_EQ(lost.by_type, "");
            EXPECT_EQ(lost_ids(written, written).by_compression, "");
        }
    EXPECT_GT(lossy, 3);
}

TEST(LostIds, AreThoseThatATypeHasNoRoomFor) {
    const auto is_lost = [](TypeDesc from, TypeDesc to) {
        const LostIds lost = lost_ids(spec_of(from, {"id"}, "zip"), spec_of(to, {"id"}, ""));
        EXPECT_TRUE(lost.by_type == "" || lost.by_type == "id");
        return !lost.by_type.empty();
    };
    using namespace OIIO;
    EXPECT_FALSE(is_lost(TypeUInt32, TypeUInt32));
    EXPECT_FALSE(is_lost(TypeInt32, TypeUInt32));
    EXPECT_TRUE(is_lost(TypeUInt32, TypeFloat));
    EXPECT_TRUE(is_lost(TypeUInt32, TypeHalf));
    EXPECT_FALSE(is_lost(TypeFloat, TypeFloat));
    EXPECT_TRUE(is_lost(TypeFloat, TypeHalf));
    EXPECT_TRUE(is_lost(TypeFloat, TypeUInt16));
    EXPECT_TRUE(is_lost(TypeHalf, TypeUInt32));
    EXPECT_FALSE(is_lost(TypeHalf, TypeFloat));
    EXPECT_FALSE(is_lost(TypeUInt8, TypeUInt16));
    EXPECT_FALSE(is_lost(TypeUInt16, TypeFloat));
    EXPECT_TRUE(is_lost(TypeUInt16, TypeHalf));
    EXPECT_TRUE(is_lost(TypeUInt16, TypeUInt8));
}

TEST(LostIds, AreNoChannelsOfColourAndNoneThatAreLeftOut) {
    const ImageSpec image = spec_of(OIIO::TypeFloat, {"R", "G", "B", "id"}, "zip");
    const LostIds lost = lost_ids(image, spec_of(OIIO::TypeHalf, {"R", "G", "B"}, "dwaa"));
    EXPECT_EQ(lost.by_type, "");
    EXPECT_EQ(lost.by_compression, "");
}

} // namespace
