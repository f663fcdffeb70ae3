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

} // namespace
} // namespace ddt::tool
