// SPDX-License-Identifier: Apache-2.0
// Which missing pixels share a mesh.
#include "core/fill/hole_groups.h"

#include <algorithm>
#include <string>

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

std::vector<HoleGroup> groups_of(const std::vector<std::string>& rows) {
    std::vector<uint8_t> missing;
    for (const std::string& row : rows)
        for (const char c : row)
            missing.push_back(c == '#');
    return group_holes(missing.data(), int(rows[0].size()), int(rows.size()));
}

TEST(HoleGroups, SmallHolesOfABlockAreOne) {
    const auto groups = groups_of({"#..#....", //
                                   ".#......", //
                                   "......##"});
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].pixels, (std::vector<size_t>{0, 3, 9, 22, 23}));
    EXPECT_TRUE((groups[0].box == Rect{0, 0, 8, 3}));
    EXPECT_EQ(groups[0].rim, 2u + 3 + 4 + 2 + 1);
    EXPECT_TRUE(groups_of({"...", "..."}).empty());
}

/// A row with the pixels first to last - 1 missing.
std::string row(int width, int first, int last) {
    std::string text(size_t(width), '.');
    std::fill(text.begin() + first, text.begin() + last, '#');
    return text;
}

TEST(HoleGroups, WhereABoxBeginsIsItsBlock) {
    // Across two blocks, in the second, and as large as may be.
    const auto groups = groups_of({row(200, 60, 70), row(200, 0, 0), row(200, 64, 128)});
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_TRUE((groups[0].box == Rect{60, 0, 70, 1}));
    EXPECT_TRUE((groups[1].box == Rect{64, 2, 128, 3}));
}

TEST(HoleGroups, LargeHolesAreAlone) {
    std::vector<std::string> rows(70, row(70, 3, 4)); // too high
    rows[20][10] = rows[40][10] = '#';                // of one block, beside it
    const auto groups = groups_of(rows);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_TRUE((groups[0].box == Rect{3, 0, 4, 70}));
    EXPECT_EQ(groups[0].pixels.size(), 70u);
    EXPECT_EQ(groups[0].rim, 140u);
    EXPECT_TRUE((groups[1].box == Rect{10, 20, 11, 41}));
    // Touching at a corner it is a part of the hole.
    rows[21][4] = '#';
    EXPECT_EQ(groups_of(rows)[0].pixels.size(), 71u);
}

TEST(HoleGroups, HoldEveryMissingPixelOnce) {
    constexpr int width = 300, height = 170;
    for (const int of_ten : {1, 4, 6}) {
        Random random{uint64_t(of_ten)};
        std::vector<uint8_t> missing(width * height);
        for (uint8_t& m : missing)
            m = random.below(10) < of_ten;
        std::vector<int> found(missing.size());
        for (const HoleGroup& group : group_holes(missing.data(), width, height)) {
            EXPECT_TRUE(std::is_sorted(group.pixels.begin(), group.pixels.end()));
            for (const size_t i : group.pixels) {
                ++found[i];
                const int x = int(i % width), y = int(i / width);
                EXPECT_TRUE(x >= group.box.x0 && x < group.box.x1 && y >= group.box.y0 &&
                            y < group.box.y1);
            }
        }
        for (size_t i = 0; i < missing.size(); ++i)
            ASSERT_EQ(found[i], int(missing[i])) << of_ten << ": " << i;
    }
}

} // namespace
} // namespace ddt::test
