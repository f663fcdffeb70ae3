// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/rows_together.h"

#include <climits>
#include <utility>

#include <gtest/gtest.h>

namespace ddt::tool {
namespace {

TEST(RowsInStrip, AreOneAtLeastAndNotWhateverAFileSays) {
    OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeUInt8);
    EXPECT_EQ(rows_in_strip(spec), 1);
    for (const auto& [said, rows] :
         {std::pair{32, 32}, {0, 1}, {-5, 1}, {1 << 20, 1 << 20}, {INT_MAX, 1 << 20}}) {
        spec.attribute("tiff:RowsPerStrip", said);
        EXPECT_EQ(rows_in_strip(spec), rows);
    }
}

TEST(RowsTogether, AreThoseOfAStripOrOfTilesWithinTheImage) {
    OIIO::ImageSpec spec(8, 100, 3, OIIO::TypeUInt8);
    spec.attribute("tiff:RowsPerStrip", 20);
    EXPECT_EQ(rows_together(spec), 20);
    for (const auto& [claimed, rows] : {std::pair{32, 32}, {100, 100}, {INT_MAX, 100}, {0, 1}}) {
        spec.tile_width = 16;
        spec.tile_height = claimed;
        EXPECT_EQ(rows_together(spec), rows);
    }
}

TEST(RowsToRead, AreWholeStripsOfEightMebibytes) {
    OIIO::ImageSpec spec(1 << 17, 1000, 1, OIIO::TypeUInt8); // 64 rows
    EXPECT_EQ(rows_to_read(spec, 1), 64);
    EXPECT_EQ(rows_to_read(spec, 65), 65);
    spec.attribute("tiff:RowsPerStrip", 10);
    EXPECT_EQ(rows_to_read(spec, 1), 70);
    EXPECT_EQ(rows_to_read(spec, 71), 80);
    spec.attribute("tiff:RowsPerStrip", 1 << 20);
    EXPECT_EQ(rows_to_read(spec, 1), 1 << 20);
}

} // namespace
} // namespace ddt::tool
