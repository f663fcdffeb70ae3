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

template <class C>
float cost(Gradient a, Gradient b) {
    return C::between(C::face(a.x, a.y), C::face(b.x, b.y));
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

template <class C>
void check_common() {
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const Gradient a = random_gradient(random), b = random_gradient(random);
        ASSERT_EQ(bits_of(cost<C>(a, b)), bits_of(cost<C>(b, a)));
        ASSERT_TRUE(std::isfinite(cost<C>(a, b)));
        ASSERT_NEAR(cost<C>(a, a), 0.0f, 1e-6f * (1 + a.x * a.x + a.y * a.y));
    }
    EXPECT_EQ(cost<C>({0, 0}, {0, 0}), cost<C>({0, 0}, {0, 0}));
    EXPECT_TRUE(std::isfinite(cost<C>({0, 0}, {0, 0})));
    EXPECT_GT(cost<C>({1, 0}, {-1, 0}), 1.0f);
    EXPECT_GT(cost<C>({0.5f, 0}, {0, 0.5f}), 0.1f);
}

TEST(Cost, SymmetricFiniteAndNothingBetweenEqualGradients) {
    check_common<scalar::Abn<float>>();
    check_common<scalar::Scf<float>>();
}

TEST(Cost, DispatchCallsTheOneAskedFor) {
    const auto of = [](Cost which) {
        return dispatch(which, [](auto c) { return cost<decltype(c)>({1, 0}, {-1, 0}); });
    };
    EXPECT_NEAR(of(Cost::scf), 2.0f, 1e-6f);
    EXPECT_NEAR(of(Cost::abn), 2.0f - 2 * 0.04f / 1.04f, 1e-6f);
}

TEST(Cost, DefaultMinGain) {
    EXPECT_EQ(default_min_gain(Cost::abn), 5e-3f);
    EXPECT_EQ(default_min_gain(Cost::scf), 1e-6f);
}

} // namespace
} // namespace ddt::test
