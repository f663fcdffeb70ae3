// SPDX-License-Identifier: Apache-2.0
// Where large holes are cut.
#include "core/fill/hole_pieces.h"

#include <algorithm>

#include "core/fill/hole_mesh.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// An image of which rectangles are missing.
struct Holed {
    int width, height;
    std::vector<uint8_t> missing = std::vector<uint8_t>(size_t(width) * size_t(height));

    void lack(Rect part) {
        for (int y = part.y0; y < part.y1; ++y)
            for (int x = part.x0; x < part.x1; ++x)
                missing[size_t(y) * size_t(width) + size_t(x)] = 1;
    }

    std::vector<HoleGroup> groups() const { return group_holes(missing.data(), width, height); }
};

/// A frame about `outer`, so many pixels thick.
void lack_frame(Holed& image, Rect outer, int thick) {
    image.lack({outer.x0, outer.y0, outer.x1, outer.y0 + thick});
    image.lack({outer.x0, outer.y1 - thick, outer.x1, outer.y1});
    image.lack({outer.x0, outer.y0, outer.x0 + thick, outer.y1});
    image.lack({outer.x1 - thick, outer.y0, outer.x1, outer.y1});
}

void expect_every_pixel_once(const Holed& image, const std::vector<HoleGroup>& groups) {
    std::vector<uint8_t> found(image.missing.size());
    for (const HoleGroup& group : groups) {
        EXPECT_TRUE(std::is_sorted(group.pixels.begin(), group.pixels.end()));
        for (const size_t i : group.pixels)
            ++found[i];
    }
    EXPECT_EQ(found, image.missing);
}

TEST(HolePieces, AThinHoleIsCutIntoBlocks) {
    for (const int thick : {1, 3, 8}) {
        Holed image{1000, 900};
        lack_frame(image, {20, 20, 980, 880}, thick);
        const auto groups = image.groups();
        expect_every_pixel_once(image, groups);
        EXPECT_EQ(groups.size(), 8u * 2 + 7 * 2 - 4) << thick;
        for (const HoleGroup& group : groups) {
            EXPECT_LE(group.box.width(), 128);
            EXPECT_LE(group.box.height(), 128);
            EXPECT_EQ(group.reach, 16);
            EXPECT_EQ(group.deep, thick > 2);
        }
    }
}

TEST(HolePieces, AThickerHoleIsCutIntoLargerBlocks) {
    Holed image{1000, 900};
    lack_frame(image, {20, 20, 980, 880}, 20);
    const auto groups = image.groups();
    expect_every_pixel_once(image, groups);
    EXPECT_EQ(groups.size(), 4u * 2 + 4 * 2 - 4);
    for (const HoleGroup& group : groups) {
        EXPECT_LE(group.box.width(), 256);
        EXPECT_LE(group.box.height(), 256);
        EXPECT_EQ(group.reach, 32);
    }
}

TEST(HolePieces, AThickPartStaysWhole) {
    Holed image{1000, 900};
    image.lack({400, 300, 600, 500});
    const auto alone = image.groups();
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_EQ(alone[0].reach, 0);
    image.lack({10, 398, 990, 401}); // across the image, and through it
    const auto groups = image.groups();
    expect_every_pixel_once(image, groups);
    EXPECT_GT(groups.size(), 4u);
    const auto with_middle = std::find_if(groups.begin(), groups.end(), [](const HoleGroup& group) {
        return std::binary_search(group.pixels.begin(), group.pixels.end(),
                                  size_t(400) * 1000 + 500);
    });
    ASSERT_TRUE(with_middle != groups.end());
    EXPECT_GE(with_middle->pixels.size(), alone[0].pixels.size());
    EXPECT_EQ(with_middle->box.y0, 300);
    EXPECT_EQ(with_middle->box.y1, 500);
}

TEST(HolePieces, WhatIsBeyondTheImageDoesNotMakeAHoleThin) {
    Holed image{1000, 200};
    image.lack({0, 0, 1000, 100}); // 100 steps from its end to what is there
    EXPECT_EQ(image.groups().size(), 1u);
    Holed thin{1000, 200};
    thin.lack({0, 0, 1000, 8});
    EXPECT_EQ(thin.groups().size(), 8u);
}

/// Of rings within one another each has a box of its own, and a mesh over all of that before they
/// were cut: 180 and 340 pixels for each that is missing here.
TEST(HolePieces, WhatMeshesReachGrowsWithTheHole) {
    for (const int side : {1000, 2000}) {
        Holed image{side, side};
        for (int k = 20; k < side / 2 - 20; k += 20)
            lack_frame(image, {k, k, side - k, side - k}, 1);
        const auto groups = image.groups();
        expect_every_pixel_once(image, groups);
        size_t reached = 0, pixels = 0;
        for (const HoleGroup& group : groups) {
            const size_t far = 2 * (size_t(group.reach) + 6);
            reached += (size_t(group.box.width()) + far) * (size_t(group.box.height()) + far);
            pixels += group.pixels.size();
        }
        EXPECT_LT(reached, 100 * pixels) << side;
    }
}

/// A picture with the edges of slanting stripes, and what is missing of it filled over a mesh for
/// each of these groups.
std::vector<float> filled(const Holed& holed, const std::vector<HoleGroup>& groups) {
    std::vector<float> values;
    for (int y = 0; y < holed.height; ++y)
        for (int x = 0; x < holed.width; ++x)
            values.push_back(((3 * x + 2 * y) % 47 < 19 ? 0.8f : 0.1f) + float(x % 11) / 50);
    std::vector<float> guide = values, surface = values;
    std::vector<uint8_t> inside(values.size());
    MeshOptions start; // which edges flip depends on their order too
    start.max_iterations = 0;
    const HoledImage image{values.data(), guide.data(), nullptr, holed.width, holed.height, 1,
                           nullptr};
    for (const HoleGroup& group : groups) {
        std::string error;
        HoleMesh mesh(image, image.guide, holed.missing.data(), group);
        EXPECT_TRUE(mesh.make(start, Device::cpu, {}, nullptr, error)) << error;
        EXPECT_TRUE(mesh.fill(surface.data(), inside.data(), error)) << error;
    }
    return values;
}

/// Where pieces meet, their meshes are of the same pixels.
TEST(HolePieces, CutsDoNotShow) {
    Holed holed{700, 300};
    holed.lack({10, 100, 690, 114});
    holed.lack({340, 10, 354, 290});
    std::vector<size_t> all;
    for (size_t i = 0; i < holed.missing.size(); ++i)
        if (holed.missing[i])
            all.push_back(i);
    const auto differing = [&](const std::vector<HoleGroup>& groups) {
        const HoleGroup whole = group_of(all, holed.missing.data(), holed.width, holed.height);
        const std::vector<float> one = filled(holed, {whole}), some = filled(holed, groups);
        int count = 0;
        for (const size_t i : all)
            count += one[i] != some[i];
        return count;
    };
    std::vector<HoleGroup> groups = holed.groups();
    ASSERT_GT(groups.size(), 5u);
    // Of more than four points on one circle it depends on their order which diagonals are made.
    const int few = differing(groups);
    EXPECT_LT(few, int(all.size() / 50));
    for (HoleGroup& group : groups)
        group.reach = 0;
    EXPECT_GT(differing(groups), 10 * few) << "at the ends of pieces";
}

} // namespace
} // namespace ddt::test
