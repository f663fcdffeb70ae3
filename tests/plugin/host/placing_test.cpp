// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/placing.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "plugin/host/buffer.h"

namespace ddt::host {
namespace {

/// Where pixel (x, y) of the result lies in the source.
Position position(const Placing& place, int x, int y) {
    Position p;
    uint8_t inside = 0;
    place.mapping(place.full).row(y, x, x + 1, &p, &inside);
    EXPECT_EQ(inside, 1);
    return p;
}

/// A pixel has the same place in the source however it is cut off.
TEST(Placing, FactorsKeepWhatIsCutOffInItsPlace) {
    for (const double factor : {1.0, 1.01, 1.1, 1.5, 2.0, 2.2360679, 3.7, 10.0 / 3}) {
        const Placing all = by_factors({-100, -80, 141, 93}, factor, 2);
        for (const Rect& window : {Rect{0, 0, 41, 30}, Rect{1, 3, 42, 20}, Rect{-99, -7, -2, 93},
                                   Rect{3, -80, 140, 0}}) {
            const Placing part = by_factors(window, factor, 2);
            EXPECT_GE(part.full.width(), window.width());
            EXPECT_NEAR(part.full.x0, window.x0 * factor, 1);
            EXPECT_NEAR(part.full.x1, window.x1 * factor, 1);
            // But for those that show the pixels at the rim.
            const int rim = int(factor) + 1;
            for (int x = part.full.x0 + rim; x < part.full.x1 - rim; ++x) {
                const Position p = position(part, x, part.full.y0 + 2);
                ASSERT_EQ(p.x, position(all, x, all.full.y0 + 2).x) << factor << " " << x;
                ASSERT_NEAR(double(p.x) / 65536, (x + 0.5) / factor - 0.5, 1e-4);
            }
        }
    }
}

/// By 2/1 the last would be 0.4 pixels off; a zoom is eased in by factors nearer to a whole one.
TEST(Placing, AFactorNextToASimpleOneIsNotThatOne) {
    for (const double simple : {1.0, 1.5, 2.0, 16.0})
        for (double more = 1e-6; more < 1e-4; more *= 1.3) {
            const double factor = simple + more;
            const Placing all = by_factors({0, 0, 16000, 2}, factor, 1);
            const int x = all.full.x1 - 40; // not one of those that show the rim
            EXPECT_NEAR(double(position(all, x, 0).x) / 65536, (x + 0.5) / factor - 0.5, 5e-3)
                << factor;
        }
}

TEST(Placing, AFactorIsTheSimpleOneThatItIsAFloatOf) {
    constexpr float ulp = std::numeric_limits<float>::epsilon();
    const Rect window{0, 0, 4000, 4};
    EXPECT_TRUE(about(0, 0, window, double(1 + ulp), double(1 + ulp)).copies());
    for (const double simple : {1.1, 2.0, 7.0 / 3, 11.0}) {
        const Placing exact = by_factors(window, simple, 1);
        const float near = std::nextafter(float(simple), 20.0f);
        const Placing place = by_factors(window, double(near), 1);
        for (int x = 100; x < exact.full.x1 - 100; ++x)
            ASSERT_EQ(position(place, x, 0).x, position(exact, x, 0).x) << simple;
    }
}

/// As of a size that was asked for in pixels, where a factor makes a whole one.
TEST(Placing, WholeSizesAreTheFilters) {
    for (const auto& [size, factor, larger] : {std::tuple{100, 1.1, 110},
                                               {100, double(1.1f), 110},
                                               {96, 1.25, 120},
                                               {41, 3.0, 123},
                                               {300, 1 / 0.3, 1000}}) {
        const Rect window{0, 0, size, size}, full{0, 0, larger, larger};
        const Placing place = by_factors(window, factor, factor), by_size = onto(window, full);
        ASSERT_EQ(place.full, full) << factor;
        for (int x = 0; x < larger; ++x)
            ASSERT_EQ(position(place, x, x).x, position(by_size, x, x).x) << factor << " " << x;
    }
}

TEST(Placing, AZoomsCentreStaysWhereItIs) {
    const Rect window{10, 20, 71, 60};
    for (double factor = 1; factor < 3; factor += 0.03) {
        const Placing place = about(40, 33, window, factor, factor);
        EXPECT_EQ(place.full, window);
        const Position before = position(place, 39, 32), after = position(place, 40, 33);
        EXPECT_NEAR(double(before.x + after.x) / 65536, 39 + 40, 1e-4) << factor;
        EXPECT_NEAR(double(before.y + after.y) / 65536, 32 + 33, 1e-4) << factor;
        EXPECT_NEAR(double(after.x - before.x) / 65536, 1 / factor, 1e-4) << factor;
        EXPECT_EQ(place.copies(), factor == 1);
    }
}

/// Also where its end, rounded by itself, would be another.
TEST(Placing, ASizeIsTheSameWhereverAWindowLies) {
    for (int x = -3; x <= 3; ++x) {
        const Rect r = scaled({x, 2 * x, x + 3, 2 * x + 1}, 1.5, 1.1);
        EXPECT_EQ(r.width(), 5) << x; // 4.5
        EXPECT_EQ(r.height(), 1) << x;
        EXPECT_NEAR(r.x0, x * 1.5, 0.5);
        EXPECT_NEAR(r.y0, x * 2.2, 0.5);
    }
    EXPECT_EQ(scaled({7, 7, 9, 9}, 0.1, 0.1), (Rect{1, 1, 2, 2})); // one pixel at least
}

TEST(Placing, FillingHolesNeedsTheWholeWindow) {
    const Rect window{0, 0, 1000, 900};
    const Placing place = onto(window, {0, 0, 2000, 1800});
    const Rect corner{0, 0, 10, 10};
    EXPECT_LT(needed(place, corner).width(), 600);
    EXPECT_EQ(needed(place, corner, Holes::fill), window);
    EXPECT_EQ(needed(place, corner, Holes::fill_alpha), window);
    EXPECT_TRUE(needed(place, {2000, 0, 2010, 10}, Holes::fill).empty());
    EXPECT_EQ(needed(onto(window, window), corner, Holes::fill), window);
    EXPECT_EQ(needed(onto(window, window), corner), corner);
}

TEST(MadeAtOnce, IsEverythingOfAResultOfUsualSize) {
    const Placing place = by_factors({0, 0, 4000, 3000}, 2, 2);
    ASSERT_LE(place.full.area(), most_at_once);
    EXPECT_EQ(made_at_once(place, {100, 100, 164, 164}), place.full);
    EXPECT_TRUE(made_at_once(place, {-90, 100, -10, 164}).empty());
}

TEST(MadeAtOnce, IsLittleOfALargeOne) {
    const Placing place = by_factors({0, 0, 96, 64}, 1024, 1024);
    const Rect asked{40000, 50000, 40064, 50064}, r = made_at_once(place, asked);
    EXPECT_EQ(intersection(r, asked), asked);
    EXPECT_LE(r.width(), 2560);
    EXPECT_LE(r.height(), 2560);
    // Who asks for what lies beside it finds it made.
    EXPECT_EQ(made_at_once(place, {r.x0, r.y0, r.x0 + 64, r.y0 + 64}), r);
    EXPECT_EQ(made_at_once(place, {r.x1 - 64, r.y1 - 64, r.x1, r.y1}), r);
    EXPECT_EQ(made_at_once(place, r), r);
}

TEST(MadeAtOnce, IsWhatIsAskedForWhereThatIsMuch) {
    const Placing place = by_factors({0, 0, 9000, 6000}, 2, 2);
    ASSERT_GT(place.full.area(), most_at_once);
    const Rect band{0, 700, 18000, 764}, r = made_at_once(place, band);
    EXPECT_EQ(r.x0, 0);
    EXPECT_EQ(r.x1, 18000);
    EXPECT_LT(r.y0, 700);
    EXPECT_GT(r.y1, 764);
    const Rect square{1300, 700, 2600, 2300};
    EXPECT_EQ(made_at_once(place, square), square);
    EXPECT_EQ(made_at_once(place, square, Holes::fill), place.full);
}

TEST(MadeAtOnce, IsNoMoreThanIsAskedForOfACopy) {
    const Placing place = by_factors({0, 0, 9000, 6000}, 1, 1);
    EXPECT_EQ(made_at_once(place, {5, 6, 70, 80}), (Rect{5, 6, 70, 80}));
    EXPECT_EQ(made_at_once(place, {5, 6, 70, 80}, Holes::fill), place.full);
}

} // namespace
} // namespace ddt::host
