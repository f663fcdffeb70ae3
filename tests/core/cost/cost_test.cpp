// SPDX-License-Identifier: Apache-2.0
#include "core/cost/cost.h"

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

struct Gradient {
    float x, y;
};

Gradient random_gradient(Random& random) {
    // Differences of guide values, some of them 0.
    const auto number = [&] {
        return float(random.between(-4096, 4096) * random.below(4) / 3) * (1.0f / 4096.0f);
    };
    return {number(), number()};
}

/// Of the edge (ex, ey); abn, scf and jnd do not depend on it.
template <class C>
float cost(Gradient a, Gradient b, float ex = 1, float ey = 0) {
    return C::between(C::face(a.x, a.y), C::face(b.x, b.y), ex, ey);
}

TEST(Cost, AbnIsOneMinusTheCosineBetweenTheNormals) {
    using C = scalar::Abn<float>;
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Gradient a = random_gradient(random), b = random_gradient(random);
        const double s = double(0.2f), ax = double(a.x), ay = double(a.y), bx = double(b.x),
                     by = double(b.y);
        const double exact =
            1.0 - (ax * bx + ay * by + s * s) /
                      std::sqrt((ax * ax + ay * ay + s * s) * (bx * bx + by * by + s * s));
        ASSERT_NEAR(double(cost<C>(a, b)), exact, 1e-6);
    }
}

TEST(Cost, ScfIsTheProductOfLengthsMinusTheInnerProduct) {
    using C = scalar::Scf<float>;
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const Gradient a = random_gradient(random), b = random_gradient(random);
        const double ax = double(a.x), ay = double(a.y), bx = double(b.x), by = double(b.y);
        const double lengths = std::sqrt((ax * ax + ay * ay) * (bx * bx + by * by));
        ASSERT_NEAR(double(cost<C>(a, b)), lengths - (ax * bx + ay * by), 1e-6 * (1 + lengths));
    }
}

/// Two triangles p, p + e, p + l and p + e, p, p + r of area 1/2 with heights at the four vertices:
/// what the costs of Dyn, Levin & Rippa are defined on.
struct Pair {
    int ex, ey, lx, ly, rx, ry;
    double zp, ze, zl, zr;

    explicit Pair(Random& random) {
        // A unimodular frame from random shears; the right apex anywhere with area 1/2.
        ex = 1, ey = 0, lx = 0, ly = 1;
        for (int i = 0; i < 6; ++i) {
            const int k = random.between(-2, 2);
            if (random.below(2))
                lx += k * ex, ly += k * ey;
            else
                ex += k * lx, ey += k * ly;
        }
        const int k = random.between(-3, 3);
        rx = k * ex - lx, ry = k * ey - ly;
        for (double* z : {&zp, &ze, &zl, &zr})
            *z = random.between(0, 4096) / 4096.0;
    }
    /// Gradient of the plane over p, p + e, p + (x, y), whose z there is given.
    Gradient gradient(int x, int y, double z) const {
        const double area = double(ex) * y - double(x) * ey, de = ze - zp, d = z - zp;
        return {float((de * y - d * ey) / area), float((d * ex - de * x) / area)};
    }
    Gradient left() const { return gradient(lx, ly, zl); }
    Gradient right() const { return gradient(rx, ry, zr); }
    /// How far the plane with gradient g is from height z over p + (x, y), measured upwards.
    double miss(Gradient g, int x, int y, double z) const {
        return std::fabs(zp + double(g.x) * x + double(g.y) * y - z);
    }
};

TEST(Cost, JndIsTheJumpOfTheDerivativeAcrossTheEdge) {
    Random random(4);
    for (int i = 0; i < 5000; ++i) {
        const Pair pair(random);
        const Gradient g = pair.left(), h = pair.right();
        const double length = std::hypot(pair.ex, pair.ey);
        const double jump = std::fabs((double(g.x) - double(h.x)) * -pair.ey +
                                      (double(g.y) - double(h.y)) * pair.ex) /
                            length;
        ASSERT_NEAR(double(cost<scalar::Jnd<float>>(g, h)), jump, 1e-5 * (1 + jump));
    }
}

TEST(Cost, DlpIsHowFarEachPlaneMissesTheOtherApexUpwards) {
    Random random(5);
    for (int i = 0; i < 5000; ++i) {
        const Pair pair(random);
        const Gradient g = pair.left(), h = pair.right();
        const auto c = double(cost<scalar::Dlp<float>>(g, h, float(pair.ex), float(pair.ey)));
        ASSERT_NEAR(c, pair.miss(g, pair.rx, pair.ry, pair.zr), 1e-4);
        ASSERT_NEAR(c, pair.miss(h, pair.lx, pair.ly, pair.zl), 1e-4);
    }
}

TEST(Cost, DpIsTheSumOfTheDistancesOfThePlanesFromTheOtherApex) {
    Random random(6);
    for (int i = 0; i < 5000; ++i) {
        const Pair pair(random);
        const Gradient g = pair.left(), h = pair.right();
        // Heights in units of s, so distances are too.
        const auto slant = [](Gradient k) {
            return std::sqrt(0.04 + double(k.x) * k.x + double(k.y) * k.y);
        };
        const double expected = pair.miss(g, pair.rx, pair.ry, pair.zr) / slant(g) +
                                pair.miss(h, pair.lx, pair.ly, pair.zl) / slant(h);
        ASSERT_NEAR(double(cost<scalar::Dp<float>>(g, h, float(pair.ex), float(pair.ey))), expected,
                    1e-3);
    }
}

template <class C>
void check_common() {
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const Gradient a = random_gradient(random), b = random_gradient(random);
        ASSERT_EQ(bits_of(cost<C>(a, b)), bits_of(cost<C>(b, a)));
        ASSERT_TRUE(std::isfinite(cost<C>(a, b)));
        ASSERT_NEAR(cost<C>(a, a), 0.0f, 1e-6f * (1 + a.x * a.x + a.y * a.y));
    }
    EXPECT_NEAR(cost<C>({0, 0}, {0, 0}), 0.0f, 1e-6f); // no quotient of nothing
    EXPECT_GT(cost<C>({1, 0}, {-1, 0}), 1.0f);
    EXPECT_GT(cost<C>({0.5f, 0}, {0, 0.5f}), 0.1f);
}

TEST(Cost, SymmetricFiniteAndNothingBetweenEqualGradients) {
#define DDT_CHECK(name, Class, ...) check_common<scalar::Class<float>>();
    DDT_COSTS(DDT_CHECK)
#undef DDT_CHECK
}

TEST(Cost, DispatchCallsTheOneAskedFor) {
    const auto of = [](Cost which) {
        return dispatch(which, [](auto c) { return cost<decltype(c)>({1, 0}, {-1, 0}); });
    };
    EXPECT_NEAR(of(Cost::scf), 2.0f, 1e-6f);
    EXPECT_NEAR(of(Cost::abn), 2.0f - 2 * 0.04f / 1.04f, 1e-6f);
    EXPECT_NEAR(of(Cost::jnd), 2.0f, 1e-6f);
    EXPECT_NEAR(of(Cost::dlp), 2.0f, 1e-6f);
    EXPECT_NEAR(of(Cost::dp), 4.0f / std::sqrt(1.04f), 1e-6f);
}

} // namespace
} // namespace ddt::test
