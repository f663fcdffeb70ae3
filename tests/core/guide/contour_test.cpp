// SPDX-License-Identifier: Apache-2.0
#include "core/guide/contour.h"

#include <cmath>

#include "core/base/arith.h"
#include "core/base/float_mode.h"
#include "tests/core/helpers.h"

namespace ddt {
namespace scalar {
#include "core/guide/contour-inl.h"
} // namespace scalar

namespace test {
namespace {

struct Fields {
    int xx, yy, xy;
};
Fields fields(uint32_t word) {
    return {int(word) & contour_mask, int(word >> contour_bits) & contour_mask, contour_xy(word)};
}

std::vector<uint32_t> words_of(const std::vector<float>& guide, int width, int height) {
    ContourRows rows(guide.data(), width, height);
    std::vector<uint32_t> words;
    for (int y = 0; y + 1 < height; ++y) {
        const uint32_t* row = rows.next();
        words.insert(words.end(), row, row + width - 1);
    }
    return words;
}

/// The same a cell at a time, by the scalar twin of the formulas; the outermost cells repeat.
class Slow {
public:
    Slow(const std::vector<float>& guide, int width, int height)
        : m_guide(guide), m_width(width), m_height(height) {}

    uint32_t word(int x, int y) const {
        const auto mean = [&](float scalar::Tensor::*part) {
            float row[7];
            for (int j = 0; j < 7; ++j)
                row[j] = along(x, y + j - 3, part);
            return smooth(row);
        };
        return scalar::contour_word(
            {mean(&scalar::Tensor::xx), mean(&scalar::Tensor::yy), mean(&scalar::Tensor::xy)});
    }

private:
    static float smooth(const float (&v)[7]) {
        return scalar::smooth(v[0], v[1], v[2], v[3], v[4], v[5], v[6]);
    }
    float along(int x, int y, float scalar::Tensor::*part) const {
        float cell[7];
        for (int i = 0; i < 7; ++i)
            cell[i] = tensor(x + i - 3, y).*part;
        return smooth(cell);
    }
    scalar::Tensor tensor(int x, int y) const {
        x = std::clamp(x, 0, m_width - 2);
        y = std::clamp(y, 0, m_height - 2);
        const float* z = m_guide.data() + size_t(y) * size_t(m_width) + size_t(x);
        return scalar::cell_tensor(z[0], z[1], z[m_width], z[m_width + 1]);
    }
    const std::vector<float>& m_guide;
    int m_width, m_height;
};

TEST(Contours, RowsAreThoseOfTheScalarTwin) {
    on_each_target([] {
        for (const auto& size : {Pixel{2, 2}, Pixel{2, 9}, Pixel{3, 3}, Pixel{9, 2}, Pixel{19, 7},
                                 Pixel{35, 12}, Pixel{70, 9}})
            for (const Kind kind : all_kinds) {
                const auto guide = make_guide(kind, size.x, size.y, 5);
                const auto words = words_of(guide, size.x, size.y);
                const Slow slow(guide, size.x, size.y);
                for (int y = 0; y + 1 < size.y; ++y)
                    for (int x = 0; x + 1 < size.x; ++x)
                        ASSERT_EQ(words[size_t(y * (size.x - 1) + x)], slow.word(x, y))
                            << size.x << " x " << size.y << ", kind " << int(kind) << ", cell " << x
                            << ", " << y;
            }
    });
}

/// A half plane whose border runs along (dx, dy) through the middle, two pixels wide.
std::vector<float> half_plane(int size, double dx, double dy) {
    std::vector<float> guide;
    const double length = std::hypot(dx, dy);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double across = ((x - size / 2) * dy - (y - size / 2) * dx) / length;
            guide.push_back(
                float(std::round(4096 * std::clamp(0.5 + across / 2, 0.0, 1.0)) / 4096));
        }
    return guide;
}

// N of a straight contour is the projection on its normal.
TEST(Contours, TellTheDirection) {
    const int size = 24;
    for (const auto& d :
         {Pixel{1, 0}, Pixel{0, 1}, Pixel{1, 1}, Pixel{-1, 1}, Pixel{3, 1}, Pixel{-2, 5}}) {
        const auto words = words_of(half_plane(size, d.x, d.y), size, size);
        const Fields n = fields(words[size_t((size / 2) * (size - 1) + size / 2)]);
        const double square = d.x * d.x + d.y * d.y, share = contour_steps * 0.96;
        EXPECT_NEAR(n.xx, share * d.y * d.y / square, 0.05 * contour_steps) << d.x << ", " << d.y;
        EXPECT_NEAR(n.yy, share * d.x * d.x / square, 0.05 * contour_steps) << d.x << ", " << d.y;
        EXPECT_NEAR(n.xy, -share * d.x * d.y / square, 0.05 * contour_steps) << d.x << ", " << d.y;
    }
}

TEST(Contours, OfNothingAreAlikeInAllDirections) {
    for (const uint32_t word : words_of(make_guide(Kind::flat, 12, 9, 1), 12, 9)) {
        const Fields n = fields(word);
        EXPECT_EQ(n.xx, contour_steps / 100);
        EXPECT_EQ(n.yy, contour_steps / 100);
        EXPECT_EQ(n.xy, 0);
    }
}

// A tensor's direction of 46 steps and more is whole, and a shorter one less by its fourth power.
TEST(Contours, OfManyDirectionsHaveHardlyOne) {
    const float trace = 1e6f * contour_noise; // far above noise
    for (const double angle : {0.0, 0.4, 1.1, 2.9})
        for (const auto& [length, want] :
             {std::pair{128.0, 128.0}, {46.0, 46.0}, {32.0, 8.0}, {16.0, 0.25}}) {
            const double share = length / contour_steps;
            const double turn = share * std::cos(angle), xy = share * std::sin(angle);
            const Fields n = fields(scalar::contour_word(
                {float(trace * (0.5 + turn)), float(trace * (0.5 - turn)), float(trace * xy)}));
            EXPECT_EQ(n.xx + n.yy, contour_steps + contour_steps / 50) << length;
            EXPECT_NEAR(n.xx - n.yy, 2 * want * std::cos(angle), 1.1) << length << ", " << angle;
            EXPECT_NEAR(n.xy, want * std::sin(angle), 1.1) << length << ", " << angle;
        }
}

// Two words are added without a carry, whatever the guide.
TEST(Contours, FieldsKeepToTheirBits) {
    Random random(9);
    for (const float scale : {1e-30f, 1e-3f, 1.0f, 1024.0f, 1e18f, 3e38f}) {
        std::vector<float> guide;
        for (int i = 0; i < 20 * 20; ++i)
            guide.push_back((random.unit() - 0.5f) * scale);
        guide[77] = std::numeric_limits<float>::quiet_NaN();
        guide[301] = std::numeric_limits<float>::infinity();
        for (const uint32_t word : words_of(guide, 20, 20)) {
            const Fields n = fields(word);
            ASSERT_LE(2 * n.xx, contour_mask);
            ASSERT_LE(2 * n.yy, contour_mask);
            ASSERT_LE(std::abs(n.xy), contour_steps / 2 + contour_steps / 100);
            ASSERT_LT(word, 1u << 30);
        }
    }
}

// Devices may keep denormal floats or take them for zero, and CPUs other than DenormalsAreZero's
// keep them.
TEST(Contours, DoNotDependOnDenormals) {
    Random random(11);
    for (const float scale : {1e15f, 1e17f, 3e17f, 1e18f, 1e19f}) {
        std::vector<float> guide;
        for (int i = 0; i < 20 * 20; ++i)
            guide.push_back((random.unit() - 0.5f) * scale);
        const std::vector<uint32_t> kept = words_of(guide, 20, 20);
        const DenormalsAreZero as_on_gpus;
        EXPECT_EQ(words_of(guide, 20, 20), kept) << scale;
    }
}

} // namespace
} // namespace test
} // namespace ddt
