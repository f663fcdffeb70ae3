// SPDX-License-Identifier: Apache-2.0
// What a whole process takes at its peak: input, output and at most 256 MiB more.
#include "tests/child_process.h"
#include "tests/many_threads.h"
#include "tests/plugin/images.h"

namespace {

constexpr int64_t allowed = int64_t(256) << 20;

/// Enlarge a picture by factors, on more threads than there is memory for.
bool enlarge(const char* filter, int side, int channels, double x, double y) {
    const ddt::test::ManyThreads many(16);
    auto src = images::make(side, side, channels, OIIO::TypeUInt8);
    auto* pixels = static_cast<unsigned char*>(src.localpixels());
    for (int row = 0; row < side; ++row)
        for (int i = 0; i < side * channels; ++i)
            *pixels++ = (unsigned char)((i * i / 64 + row * row / 48) / 16 % 200);
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    ddt::Options options;
    std::string error;
    if (!ddt::parse_filter(filter, options, error))
        return false;
    OIIO::ImageBuf dst;
    const OIIO::ROI size(0, int(side * x), 0, int(side * y), 0, 1, 0, channels);
    return ddt::resize(dst, src, options, size, 16);
}

void expect_bounded(const char* filter, int side, int channels, double x, double y) {
    const int64_t in = int64_t(side) * side * channels, out = int64_t(double(in) * x * y);
    const auto ended =
        ddt::test::in_child([=] { return enlarge(filter, side, channels, x, y) ? 0 : 1; }, 600);
    ASSERT_EQ(ended.code, 0);
    const int64_t beside = ended.peak_resident - in - out;
    ASSERT_GE(beside, 0);
    EXPECT_LE(beside, allowed);
    std::printf("%s: %d MiB beside input and output\n", filter, int(beside >> 20));
}

TEST(PeakMemory, SixtyFourMegapixels) {
    expect_bounded("ddt", 1024, 3, 8, 8);
}

TEST(PeakMemory, SixtyFourMegapixelsCorrectedAndSoft) {
    expect_bounded("ddt-sharp,consistency=2,soft=0.3", 1024, 3, 8, 8);
}

TEST(PeakMemory, TwoHundredAndFiftySixMegapixels) {
    expect_bounded("ddt", 2048, 1, 8, 8);
}

TEST(PeakMemory, OneAxisGrowsTheOtherShrinks) {
    expect_bounded("ddt-linear", 1024, 3, 8, 0.5);
}

} // namespace
