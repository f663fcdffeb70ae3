// SPDX-License-Identifier: Apache-2.0
// The metrics of the paper's table 3 on cases whose value is known by hand.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "metrics/correlation.h"
#include "metrics/mse.h"
#include "metrics/snr.h"
#include "metrics/uiqi.h"

using metrics::Plane;

namespace {

Plane row(std::initializer_list<double> values) {
    Plane plane(int(values.size()), 1);
    plane.values = values;
    return plane;
}

Plane checkers(int size, double even, double odd) {
    Plane plane(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            plane.at(x, y) = (x + y) % 2 ? odd : even;
    return plane;
}

} // namespace

TEST(Mse, IsTheMeanOfSquares) {
    // Differences 1, -2, 0, 3: 14 / 4.
    EXPECT_DOUBLE_EQ(mse(row({1, 2, 3, 4}), row({0, 4, 3, 1})), 3.5);
    EXPECT_EQ(mse(row({5, 6}), row({5, 6})), 0);
}

TEST(Snr, IsTheRatioOfEnergies) {
    // 100 / 1: 20 dB.
    EXPECT_DOUBLE_EQ(snr(row({6, 8}), row({6, 9})), 20);
    // 25 / 25: 0 dB.
    EXPECT_DOUBLE_EQ(snr(row({3, 4}), row({0, 0})), 0);
    EXPECT_EQ(snr(row({3, 4}), row({3, 4})), std::numeric_limits<double>::infinity());
    EXPECT_EQ(snr(row({0, 0}), row({3, 4})), -std::numeric_limits<double>::infinity());
}

TEST(Correlation, IgnoresBrightnessAndContrast) {
    EXPECT_DOUBLE_EQ(correlation(row({1, 2, 3, 4}), row({1, 2, 3, 4})), 1);
    EXPECT_DOUBLE_EQ(correlation(row({1, 2, 3, 4}), row({30, 50, 70, 90})), 1);
    EXPECT_DOUBLE_EQ(correlation(row({1, 2, 3, 4}), row({4, 3, 2, 1})), -1);
    // Deviations (-1, 0, 1) and (1, -2, 1).
    EXPECT_DOUBLE_EQ(correlation(row({1, 2, 3}), row({4, 1, 4})), 0);
    // Deviations (-1, 0, 1) and (-2, 1, 1): 3 / sqrt(2 * 6).
    EXPECT_DOUBLE_EQ(correlation(row({1, 2, 3}), row({0, 3, 3})), 3 / std::sqrt(12));
}

TEST(Correlation, OfFlatPlanes) {
    EXPECT_EQ(correlation(row({5, 5}), row({9, 9})), 1);
    EXPECT_EQ(correlation(row({5, 5}), row({8, 9})), 0);
    // Of numbers that are no integers the deviations are what was rounded off.
    EXPECT_EQ(correlation(Plane(9, 9, 102.6), Plane(9, 9, 0.1)), 1);
    EXPECT_EQ(correlation(Plane(9, 9, 102.6), checkers(9, 0, 1)), 0);
}

TEST(CrossCorrelation, TellsBrightness) {
    EXPECT_DOUBLE_EQ(cross_correlation(row({3, 4}), row({3, 4})), 1);
    EXPECT_DOUBLE_EQ(cross_correlation(row({3, 4}), row({6, 8})), 2);
    // (3 * 4 + 4 * 3) / 25
    EXPECT_DOUBLE_EQ(cross_correlation(row({3, 4}), row({4, 3})), 24.0 / 25);
    EXPECT_EQ(cross_correlation(row({0, 0}), row({1, 2})), 1);
}

TEST(Uiqi, EqualAndInverted) {
    EXPECT_DOUBLE_EQ(uiqi(checkers(12, 10, 200), checkers(12, 10, 200)), 1);
    // Same mean and variance, covariance turned round.
    EXPECT_DOUBLE_EQ(uiqi(checkers(12, 10, 200), checkers(12, 200, 10)), -1);
}

TEST(Uiqi, BrightnessAndContrastHaveTheirFactors) {
    // Means 10 and 20, the same deviation: 2 * 10 * 20 / (100 + 400).
    EXPECT_DOUBLE_EQ(uiqi(checkers(8, 5, 15), checkers(8, 15, 25)), 0.8);
    // The same mean, deviations 5 and 10: 2 * 5 * 10 / (25 + 100).
    EXPECT_DOUBLE_EQ(uiqi(checkers(8, 15, 25), checkers(8, 10, 30)), 0.8);
}

TEST(Uiqi, FlatAndBlackWindows) {
    EXPECT_DOUBLE_EQ(uiqi(Plane(9, 9, 10), Plane(9, 9, 20)), 0.8);
    EXPECT_DOUBLE_EQ(uiqi(Plane(9, 9, 0), Plane(9, 9, 0)), 1);
    EXPECT_DOUBLE_EQ(uiqi(Plane(9, 9, 10), checkers(9, 0, 0)), 0);
    EXPECT_DOUBLE_EQ(uiqi(Plane(9, 9, 51.3), Plane(9, 9, 102.6)), 0.8);
    EXPECT_DOUBLE_EQ(uiqi(Plane(9, 9, 0.1), Plane(9, 9, 0.2)), 0.8);
}

TEST(Uiqi, IsTheMeanOverWindows) {
    // 9 wide: two windows, in columns 0-7 and 1-8; planes differ in column 8 only.
    Plane a = checkers(9, 10, 20), b = a;
    for (int y = 0; y < 9; ++y)
        b.at(8, y) = a.at(8, y) + 1;
    EXPECT_LT(uiqi(a, b), 1);
    EXPECT_GT(uiqi(a, b), 0.5);
    EXPECT_DOUBLE_EQ(uiqi(Plane(3, 2, 10), Plane(3, 2, 20)), 0.8);
}
