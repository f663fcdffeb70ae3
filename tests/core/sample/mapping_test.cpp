// SPDX-License-Identifier: Apache-2.0
#include "ddt/core.h"

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

using Axis = ResizeMapping::Axis;

Axis random_axis(Random& random) {
    Axis a;
    a.from0 = random.between(-50, 50);
    a.from_size = random.between(1, 60);
    a.to0 = random.between(-80, 80);
    a.to_size = a.from_size + random.below(400);
    a.window0 = a.from0 + random.between(-10, 10);
    a.window1 = a.window0 + random.between(1, 70);
    a.out0 = a.to0 + random.between(-20, 20);
    a.out1 = a.out0 + random.between(0, 300);
    return a;
}

/// Whether p is from0 + (i + 1/2 - to0) from_size / to_size - 1/2 in 2^-16 pixel, clamped and
/// rounded to the nearest, halves up. By p - 1/2 <= exact < p + 1/2 in whole numbers.
::testing::AssertionResult is_position(const Axis& a, int i, int64_t p) {
    const __int128 one = position_one;
    const __int128 d = __int128(2) * a.to_size;
    const __int128 n = (__int128(2) * i + 1 - __int128(2) * a.to0) * a.from_size * one +
                       (__int128(2) * a.from0 - 1) * one * a.to_size;
    const __int128 low = a.window0 * one, high = (a.window1 - 1) * one;
    const bool nearest = (2 * p - 1) * d <= 2 * n && 2 * n < (2 * p + 1) * d;
    const bool at_low = p == low && 2 * n < (2 * low + 1) * d;
    const bool at_high = p == high && 2 * n >= (2 * high - 1) * d;
    if (p >= low && p <= high && (nearest || at_low || at_high))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "position(" << i << ") = " << p;
}

TEST(Mapping, PositionIsTheExactOneRounded) {
    Random random(1);
    for (int k = 0; k < 3000; ++k) {
        const Axis a = random_axis(random);
        for (int i = a.out0; i < a.out1; i += 1 + random.below(9))
            ASSERT_TRUE(is_position(a, i, a.position(i)));
    }
}

TEST(Mapping, PositionIsExactForHugeWindows) {
    Random random(2);
    constexpr int far = 1 << 29;
    for (int k = 0; k < 3000; ++k) {
        Axis a;
        a.from0 = a.window0 = random.between(-far, far - 1000000);
        a.from_size = random.between(1, 1000000);
        a.window1 = a.window0 + a.from_size;
        a.to0 = random.between(-far, far);
        a.to_size = random.between(a.from_size, far);
        const int i = a.to0 + random.below(a.to_size);
        ASSERT_TRUE(is_position(a, i, a.position(i)));
    }
}

TEST(Mapping, WhatIsFarOutsideIsAtTheWindowsEnds) {
    constexpr int far = 1 << 29;
    const Axis a{0, far, 0, 1, 0, far, -far, far};
    EXPECT_EQ(a.first_at_or_after(1 << 28), 1);
    std::vector<Position> row(9);
    std::vector<uint8_t> inside(9);
    for (const int i : {-far, -(1 << 19), -1, 1, 1 << 18, 1 << 19, far - 9}) {
        ASSERT_TRUE(is_position(a, i, a.position(i))) << i;
        ResizeMapping(a, a).row(0, i, i + 9, row.data(), inside.data());
        for (int k = 0; k < 9; ++k)
            ASSERT_TRUE(is_position(a, i + k, row[size_t(k)].x)) << i + k;
    }
}

TEST(Mapping, SameSizeIsTheIdentity) {
    Axis a;
    a.from0 = -7;
    a.to0 = 20;
    a.from_size = a.to_size = 31;
    a.window0 = -7;
    a.window1 = 24;
    for (int i = 0; i < 31; ++i)
        EXPECT_EQ(a.position(20 + i), int64_t(i - 7) * position_one);
}

TEST(Mapping, PositionsAreMirrorImages) {
    // To the last unit: halves are rounded up on both sides.
    Random random(3);
    for (int k = 0; k < 500; ++k) {
        Axis a = random_axis(random);
        a.window0 = a.from0;
        a.window1 = a.from0 + a.from_size;
        const int64_t sum = (2 * int64_t(a.from0) + a.from_size - 1) * position_one;
        for (int i = 0; i < a.to_size; ++i) {
            const int64_t mirrored = a.position(a.to0 + a.to_size - 1 - i);
            const int64_t off = a.position(a.to0 + i) + mirrored - sum;
            ASSERT_TRUE(off == 0 || off == 1);
        }
    }
}

TEST(Mapping, ShiftedWindowsShiftThePositions) {
    Random random(4);
    for (int k = 0; k < 500; ++k) {
        const Axis a = random_axis(random);
        Axis b = a;
        const int from = random.between(-100000, 100000), to = random.between(-100000, 100000);
        b.from0 += from;
        b.window0 += from;
        b.window1 += from;
        b.to0 += to;
        b.out0 += to;
        b.out1 += to;
        for (int i = a.out0; i < a.out1; ++i)
            ASSERT_EQ(b.position(i + to), a.position(i) + int64_t(from) * position_one);
        ASSERT_EQ(b.first_at_or_after(from + 5), a.first_at_or_after(5) + to);
    }
}

TEST(Mapping, FirstAtOrAfterIsThatOfALinearSearch) {
    Random random(5);
    for (int k = 0; k < 2000; ++k) {
        const Axis a = random_axis(random);
        const int limit = random.between(a.window0 - 3, a.window1 + 3);
        int expected = a.out0;
        while (expected < a.out1 && a.position(expected) < int64_t(limit) * position_one)
            ++expected;
        ASSERT_EQ(a.first_at_or_after(limit), expected);
    }
}

TEST(Mapping, ScaleIsThatOfTheWindows) {
    const ResizeMapping mapping({7, 20, -3, 50, 0, 40, 0, 90}, {0, 10, 0, 10, 2, 9, 1, 5});
    EXPECT_EQ(mapping.scale().x, 2.5);
    EXPECT_EQ(mapping.scale().y, 1.0);
}

TEST(Mapping, ReachHoldsExactlyThePixelsInside) {
    Random random(6);
    constexpr double beyond = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 300; ++k) {
        const Axis ax = random_axis(random), ay = random_axis(random);
        const ResizeMapping mapping(ax, ay);
        EXPECT_TRUE(mapping.separable());
        const double x0 = k % 3 ? random.between(-60, 60) : -beyond;
        const double x1 = k % 5 ? random.between(-60, 110) : beyond;
        const Rect r = mapping.reach(x0, -beyond, x1, beyond);
        EXPECT_EQ(r.y0, ay.out0);
        EXPECT_EQ(r.y1, ay.out1);
        for (int i = ax.out0; i < ax.out1; ++i) {
            const double p = double(ax.position(i)) / position_one;
            ASSERT_EQ(i >= r.x0 && i < r.x1, p >= x0 && p < x1);
        }
        const Rect t = mapping.reach(-beyond, x0, beyond, x1);
        EXPECT_EQ(t.x0, ax.out0);
        for (int i = ay.out0; i < ay.out1; ++i) {
            const double p = double(ay.position(i)) / position_one;
            ASSERT_EQ(i >= t.y0 && i < t.y1, p >= x0 && p < x1);
        }
    }
}

// Where a unit is a whole number of pixels, some positions lie on the border of two units.
TEST(Mapping, RowIsThePositionsWhereTheyAreExactToo) {
    for (const int from : {1, 5, 7, 12, 100003})
        for (const int to : {1 << 16, 3 << 16, 15 << 17}) {
            Axis a = Axis::whole(from, to);
            a.to0 = -1000;
            for (const int begin : {a.to0, a.to0 + 777, a.to0 + to / 2}) {
                a.out0 = begin;
                a.out1 = begin + 2000;
                const ResizeMapping mapping(a, a);
                std::vector<Position> positions(2000);
                std::vector<uint8_t> inside(2000);
                mapping.row(begin, a.out0, a.out1, positions.data(), inside.data());
                for (int i = 0; i < 2000; ++i)
                    ASSERT_EQ(positions[size_t(i)].x, a.position(begin + i))
                        << from << " " << to << " " << i;
            }
        }
}

TEST(Mapping, RowIsThePositionsOfBothAxes) {
    Random random(7);
    for (int k = 0; k < 50; ++k) {
        const Axis ax = random_axis(random), ay = random_axis(random);
        const ResizeMapping mapping(ax, ay);
        const int n = ax.out1 - ax.out0;
        std::vector<Position> positions(size_t(n) + 1, Position{7, 7});
        std::vector<uint8_t> inside(size_t(n) + 1, 2);
        mapping.row(ay.out0 + 3, ax.out0, ax.out1, positions.data(), inside.data());
        for (int i = 0; i < n; ++i) {
            ASSERT_EQ(positions[size_t(i)].x, ax.position(ax.out0 + i));
            ASSERT_EQ(positions[size_t(i)].y, ay.position(ay.out0 + 3));
            ASSERT_EQ(inside[size_t(i)], 1);
        }
        ASSERT_EQ(positions[size_t(n)].x, 7);
        ASSERT_EQ(inside[size_t(n)], 2);
    }
}

} // namespace
} // namespace ddt::test
