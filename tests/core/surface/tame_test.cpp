// SPDX-License-Identifier: Apache-2.0
#include "core/surface/tame.h"

#include <cmath>
#include <limits>

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

TEST(Tame, OneValueThatIsNotIsFoundAnywhere) {
    const float inf = std::numeric_limits<float>::infinity(),
                over = std::nextafter(tame_value, inf);
    on_each_target([&] {
        for (size_t n = 0; n < 70; ++n) {
            std::vector<float> values(n, 0.5f);
            for (size_t i = 0; i < n; ++i) {
                for (const float tame : {tame_value, -tame_value, 0.0f, -0.0f, 1e-45f}) {
                    values[i] = tame;
                    ASSERT_TRUE(all_tame(values.data(), n)) << n << ' ' << i << ' ' << tame;
                }
                for (const float wild : {over, -over, inf, -inf, std::nanf(""), -std::nanf("")}) {
                    values[i] = wild;
                    ASSERT_FALSE(all_tame(values.data(), n)) << n << ' ' << i << ' ' << wild;
                    // What comes after is not asked for.
                    ASSERT_TRUE(all_tame(values.data(), i)) << n << ' ' << i << ' ' << wild;
                }
                values[i] = 0.5f;
            }
        }
    });
}

} // namespace
} // namespace ddt::test
