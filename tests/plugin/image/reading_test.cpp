// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/reading.h"

#include <cmath>

#include "plugin/image/channels.h"
#include "tests/plugin/image/named.h"
#include "tests/plugin/images.h"

namespace {

ddt::Reading reading_of(const OIIO::ImageSpec& spec, const ddt::Options& options = {}) {
    ddt::Reading reading;
    std::string error;
    EXPECT_TRUE(
        ddt::plan_reading(OIIO::ImageBuf(spec), options, OIIO::get_roi(spec), reading, error))
        << error;
    return reading;
}

TEST(Reading, EveryInkMakesTheGuide) {
    const ddt::Reading reading = reading_of(ddt::test::named({"C", "K", "M", "Y"}));
    EXPECT_FALSE(reading.light.known());
    float pixels[5 * 4] = {};
    for (int ink = 0; ink < 4; ++ink)
        pixels[4 * ink + ink] = 0.5f;
    float guide[5];
    ddt::make_guide(reading.guide, pixels, 5, 4, guide);
    for (int ink = 0; ink < 4; ++ink)
        EXPECT_GT(guide[ink], guide[4] + 0.1f) << ink;
}

TEST(Reading, InksStayTheirNumbersWhateverTheLight) {
    ddt::Options options;
    options.light = "sRGB";
    EXPECT_FALSE(reading_of(ddt::test::named({"C", "M", "Y", "K"}), options).light.converts());
    EXPECT_TRUE(reading_of(ddt::test::named({"R", "G", "B"}), options).light.converts());
}

} // namespace
