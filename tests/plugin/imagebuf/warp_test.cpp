// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/matrix.h"

#include <cmath>

#include <OpenImageIO/Imath.h>

#include "tests/many_threads.h"
#include "tests/plugin/images.h"

namespace {

using images::bytes;
using images::make;
using images::value;
using images::window;
using OIIO::ImageBuf;
using OIIO::ROI;
using Matrix = Imath::M33f;

ImageBuf disc_picture(int width = 24, int height = 20) {
    auto image = make(width, height, 3);
    images::fill(image, [](int x, int y, int c) { return images::disc(x + c, y, 24); });
    return image;
}

ImageBuf warped(const ImageBuf& src, const Matrix& M, ROI roi) {
    ImageBuf dst;
    EXPECT_TRUE(ddt::warp(dst, src, M, {}, false, ImageBuf::WrapDefault, roi)) << dst.geterror();
    return dst;
}

TEST(Warp, IdentityAndWholeMovesCopy) {
    const auto src = disc_picture();
    EXPECT_EQ(bytes(warped(src, Matrix(), src.roi())), bytes(src));
    const auto moved = warped(src, Matrix(1, 0, 0, 0, 1, 0, 7, -3, 1), window(0, 30, -5, 20));
    for (int y = -5; y < 20; ++y)
        for (int x = 0; x < 30; ++x) {
            const bool in = src.roi().contains(x - 7, y + 3);
            ASSERT_EQ(value(moved, x, y), in ? value(src, x - 7, y + 3) : 0.0f) << x << " " << y;
        }
}

TEST(Warp, ScalingIsResizing) {
    const auto src = disc_picture();
    const auto warp = warped(src, Matrix(4, 0, 0, 0, 3, 0, 0, 0, 1), window(0, 96, 0, 60));
    EXPECT_EQ(bytes(warp), bytes(images::enlarged(src, 96, 60)));
}

TEST(Warp, OutsideIsBlack) {
    auto src = disc_picture();
    images::fill(src, [](int, int, int) { return 1.0f; });
    // Twice as large, from (10, 10).
    const auto dst = warped(src, Matrix(2, 0, 0, 0, 2, 0, 10, 10, 1), window(0, 70, 0, 70));
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 70; ++x)
            ASSERT_EQ(value(dst, x, y), x >= 10 && x < 58 && y >= 10 && y < 50 ? 1.0f : 0.0f);
    // What was there before is gone, too.
    auto used = make(70, 70, 3);
    images::fill(used, [](int, int, int) { return 5.0f; });
    ASSERT_TRUE(ddt::warp(used, src, Matrix(2, 0, 0, 0, 2, 0, 10, 10, 1)));
    EXPECT_EQ(bytes(used), bytes(dst));
}

TEST(Warp, QuarterTurn) {
    const auto src = disc_picture();
    // (x, y) -> (20 - y, x)
    const auto dst = warped(src, Matrix(0, 1, 0, -1, 0, 0, 20, 0, 1), window(0, 20, 0, 24));
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 20; ++x)
            ASSERT_EQ(value(dst, x, y), value(src, y, 19 - x));
}

/// A plane under M, and what must show: the plane where the pixel comes from.
void expect_plane(const Matrix& M, ROI data, ROI roi) {
    auto src = make(data, data, 1);
    images::fill(src, [](int x, int y, int) { return 2 + 0.03f * float(x) + 0.01f * float(y); });
    const auto dst = warped(src, M, roi);
    const auto inverse = Imath::M33d(M).inverse();
    int shown = 0;
    for (int y = roi.ybegin; y < roi.yend; ++y)
        for (int x = roi.xbegin; x < roi.xend; ++x) {
            Imath::V2d p;
            inverse.multVecMatrix(Imath::V2d(x + 0.5, y + 0.5), p);
            const double edge = std::min(std::min(p.x - data.xbegin, data.xend - p.x),
                                         std::min(p.y - data.ybegin, data.yend - p.y));
            if (std::fabs(edge) < 1e-4)
                continue;
            if (edge < 0) {
                ASSERT_EQ(value(dst, x, y), 0.0f) << x << " " << y;
                continue;
            }
            ++shown;
            const double sx = std::clamp(p.x - 0.5, double(data.xbegin), data.xend - 1.0);
            const double sy = std::clamp(p.y - 0.5, double(data.ybegin), data.yend - 1.0);
            ASSERT_NEAR(value(dst, x, y), 2 + 0.03 * sx + 0.01 * sy, 1e-5) << x << " " << y;
        }
    EXPECT_GT(shown, 100);
}

TEST(Warp, AnyMatrixShowsThePlane) {
    const ROI data = window(-3, 21, 4, 24);
    Matrix turn;
    turn.rotate(0.5f);
    Matrix shear(1.8f, 0.3f, 0, -0.4f, 2.2f, 0, 5, 3, 1);
    Matrix mirrored(-2, 0, 0, 0, 2, 0, 40, 0, 1);
    Matrix perspective(4, 0.2f, 0.002f, 0.1f, 4, 0.004f, 1, 2, 1);
    expect_plane(turn, data, window(-20, 30, -5, 40));
    expect_plane(shear, data, window(-20, 60, 0, 70));
    expect_plane(mirrored, data, window(-20, 60, 0, 70));
    expect_plane(perspective, data, window(-20, 110, 0, 120));
}

TEST(Warp, LargeImagesUseManyTiles) {
    Matrix turn;
    turn.rotate(0.3f);
    turn *= Matrix(1.3f, 0, 0, 0, 1.3f, 0, 0, 0, 1);
    expect_plane(turn, window(0, 600, 0, 600), window(-300, 800, 0, 1000));
}

TEST(Warp, PartIsACropAndThreadsDoNotMatter) {
    const ddt::test::ManyThreads allowed;
    auto src = make(600, 300, 3, OIIO::TypeUInt8);
    images::noise(src);
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    Matrix turn;
    turn.rotate(0.2f);
    const ROI all = window(-100, 700, 0, 450), part = window(123, 311, 77, 200);
    const auto whole = warped(src, turn, all);
    EXPECT_EQ(bytes(warped(src, turn, part)), bytes(whole, part));
    for (const int threads : {1, 2, 7}) {
        ImageBuf dst;
        ASSERT_TRUE(ddt::warp(dst, src, turn, {}, false, ImageBuf::WrapBlack, all, threads));
        EXPECT_EQ(bytes(dst), bytes(whole));
    }
}

TEST(Warp, ShrinkingAndOtherWrapsAreOpenImageIOs) {
    const auto src = disc_picture();
    const Matrix half(0.5f, 0, 0, 0, 2, 0, 0, 0, 1), twice(2, 0, 0, 0, 2, 0, 0, 0, 1);
    ImageBuf dst, expected;
    ASSERT_TRUE(ddt::warp(dst, src, half));
    ASSERT_TRUE(OIIO::ImageBufAlgo::warp(expected, src, half, "", 0.0f));
    EXPECT_EQ(bytes(dst), bytes(expected));
    for (const auto wrap : {ImageBuf::WrapClamp, ImageBuf::WrapPeriodic, ImageBuf::WrapMirror}) {
        ImageBuf a, b;
        ASSERT_TRUE(ddt::warp(a, src, twice, {}, false, wrap));
        ASSERT_TRUE(OIIO::ImageBufAlgo::warp(b, src, twice, "", 0.0f, false, wrap));
        EXPECT_EQ(bytes(a), bytes(b));
    }
    EXPECT_FALSE(ddt::warp(dst, src, twice, {}, false, ImageBuf::WrapMode(7)));
    EXPECT_NE(dst.geterror().find("wrap mode 7 is not allowed; allowed are"), std::string::npos);
}

TEST(Warp, ShrinkingFillsTheMemoryItIsGivenWhateverItsType) {
    const auto src = disc_picture();
    const Matrix half(0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 1);
    const ImageBuf expected = warped(src, half, window(0, 12, 0, 10));
    std::vector<double> memory(12 * 10 * 3, -1.0);
    ImageBuf dst(OIIO::ImageSpec(12, 10, 3, OIIO::TypeDesc::DOUBLE), memory.data());
    ASSERT_TRUE(ddt::warp(dst, src, half)) << dst.geterror();
    EXPECT_EQ(dst.spec().format, OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE));
    EXPECT_EQ(dst.localpixels(), memory.data());
    size_t i = 0;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 12; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(memory[i++], double(value(expected, x, y, c))) << x << " " << y;
    // A part of some channels, where the rest stays.
    std::fill(memory.begin(), memory.end(), -1.0);
    ASSERT_TRUE(
        ddt::warp(dst, src, half, {}, false, ImageBuf::WrapDefault, ROI(2, 5, 3, 7, 0, 1, 1, 2)))
        << dst.geterror();
    i = 0;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 12; ++x)
            for (int c = 0; c < 3; ++c) {
                const bool in = x >= 2 && x < 5 && y >= 3 && y < 7 && c == 1;
                ASSERT_EQ(memory[i++], in ? double(value(expected, x, y, c)) : -1.0);
            }
    // One that is not there yet has the source's type.
    ImageBuf fresh;
    const ImageBuf of_doubles = OIIO::ImageBufAlgo::copy(src, OIIO::TypeDesc::DOUBLE);
    ASSERT_TRUE(
        ddt::warp(fresh, of_doubles, half, {}, false, ImageBuf::WrapDefault, window(0, 12, 0, 10)));
    EXPECT_EQ(fresh.spec().format, OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE));
}

TEST(Warp, WindowsAreOpenImageIOs) {
    const auto src = disc_picture();
    for (const float angle : {0.0f, 0.3f, 1.5707963f, 2.0f})
        for (const float scale : {1.0f, 1.1f, 3.0f})
            for (const bool recompute : {false, true}) {
                Matrix M;
                M.rotate(angle);
                M *= Matrix(scale, 0, 0, 0, scale, 0, 3.25f, -1, 1);
                ImageBuf a, b;
                ASSERT_TRUE(ddt::warp(a, src, M, {}, recompute)) << a.geterror();
                ASSERT_TRUE(OIIO::ImageBufAlgo::warp(b, src, M, "", 0.0f, recompute));
                EXPECT_EQ(a.roi(), b.roi());
                EXPECT_EQ(a.roi_full(), b.roi_full());
            }
}

TEST(Warp, ASinglePixelHasItsWindowsToo) {
    auto src = images::make(1, 1, 1);
    const Matrix M(4, 0, 0, 0, 4, 0, 0, 0, 1);
    const auto roi = images::window(4, 40, 0, 8);
    ImageBuf a, b;
    ASSERT_TRUE(ddt::warp(a, src, M, {}, false, ImageBuf::WrapDefault, roi)) << a.geterror();
    ASSERT_TRUE(OIIO::ImageBufAlgo::warp(b, src, M, "", 0.0f, false, ImageBuf::WrapDefault, roi));
    EXPECT_EQ(a.roi(), b.roi());
    EXPECT_EQ(a.roi_full(), b.roi_full());
}

TEST(Warp, KnowsShrinking) {
    const ddt::Rect window{0, 0, 100, 100};
    const auto shrinks = [&](std::array<double, 9> m) {
        return ddt::shrinks(ddt::Projective{m}, window);
    };
    EXPECT_FALSE(shrinks({1, 0, 0, 0, 1, 0, 0, 0, 1}));
    for (double angle = 0; angle < 7; angle += 0.1) {
        const auto s = double(float(std::sin(angle))), c = double(float(std::cos(angle)));
        EXPECT_FALSE(shrinks({c, s, 0, -s, c, 0, 10, 20, 1})) << angle;
        EXPECT_TRUE(shrinks({0.99 * c, 0.99 * s, 0, -s, c, 0, 10, 20, 1})) << angle;
    }
    EXPECT_TRUE(shrinks({1, 0.5, 0, 0, 1, 0, 0, 0, 1})); // a shear, across its diagonal
    EXPECT_FALSE(shrinks({2, 0.5, 0, 0, 2, 0, 0, 0, 1}));
    EXPECT_FALSE(shrinks({8, 0, 0.001, 0, 8, 0, 0, 0, 1}));
    EXPECT_TRUE(shrinks({8, 0, 0.1, 0, 8, 0, 0, 0, 1})); // only at its far end
}

ddt::Mapping::Scale scale_of(const ddt::Projective& m, const ddt::Rect& window) {
    ddt::Projective inverse;
    EXPECT_TRUE(m.invert(inverse));
    return ddt::MatrixMapping(inverse, m, {0, 0, 1, 1}, window, window).scale();
}

TEST(Warp, KnowsItsScale) {
    const ddt::Rect window{10, 20, 110, 70};
    const double s = std::sin(0.3), c = std::cos(0.3);
    const auto turned = scale_of({{3 * c, 3 * s, 0, -2 * s, 2 * c, 0, 5, 6, 1}}, window);
    EXPECT_NEAR(turned.x, 3, 1e-12);
    EXPECT_NEAR(turned.y, 2, 1e-12);
    // Of a perspective that in the middle, (60, 45): there w is 2.
    const auto leaning = scale_of({{4, 0, 0, 0, 4, 1.0 / 45, 0, 0, 1}}, window);
    EXPECT_NEAR(leaning.x, 2, 1e-12);
    EXPECT_NEAR(leaning.y, std::hypot(60.0 / 45, 1.0), 1e-12);
}

// In a pan frames that move by whole pixels look as the others do.
TEST(Warp, SharpDoesNotJumpAtWholeMoves) {
    const auto src = disc_picture();
    ddt::Options sharp;
    sharp.surface.consistency = 2;
    const auto at = [&](float x) {
        ImageBuf dst;
        EXPECT_TRUE(ddt::warp(dst, src, Matrix(1, 0, 0, 0, 1, 0, x, 0, 1), sharp, false,
                              ImageBuf::WrapDefault, window(2, 20, 2, 18)));
        return dst;
    };
    const auto same = OIIO::ImageBufAlgo::compare(at(1), at(1 + 1e-4f), 0, 0);
    EXPECT_LE(same.maxerror, 1e-3);
}

TEST(Warp, KnowsWholeMoves) {
    int dx = 0, dy = 0;
    const auto moves = [&](std::array<double, 9> m) {
        return ddt::moves_only(ddt::Projective{m}, dx, dy);
    };
    const std::array<double, 9> whole{1, 0, 0, 0, 1, 0, 7, -3, 1};
    EXPECT_TRUE(moves(whole));
    EXPECT_EQ(dx, 7);
    EXPECT_EQ(dy, -3);
    for (size_t i = 0; i < 9; ++i)
        for (const double by : {0.5, 1e9}) {
            auto other = whole;
            other[i] += by;
            EXPECT_FALSE(moves(other)) << i << " " << by;
        }
}

// A horizon within the picture: nothing to be right about, but it must end, and in one piece.
TEST(Warp, HorizonWithinThePicture) {
    const auto src = disc_picture();
    const auto dst = warped(src, Matrix(60, 0, 0.1f, 0, 60, 0, 0, 0, -1), window(-50, 50, -50, 50));
    EXPECT_EQ(dst.spec().width, 100);
}

TEST(Warp, CountsWhatAFilterGoesThrough) {
    const ddt::Rect output{0, 0, 10, 20};
    const auto count = [&](std::array<double, 9> m) {
        return ddt::filtered_pixels(ddt::Projective{m}, output, 6);
    };
    EXPECT_EQ(count({1, 0, 0, 0, 1, 0, 5, 5, 1}), 200 * 7 * 7);
    EXPECT_EQ(count({2, 0, 0, 0, 4, 0, 0, 0, 1}), 200 * 13 * 25);
    EXPECT_EQ(count({0, 2, 0, -4, 0, 0, 0, 0, 1}), 200 * 25 * 13);
    EXPECT_EQ(count({0.1, 0, 0, 0, 0.1, 0, 0, 0, 1}), 200 * 7 * 7);
    EXPECT_EQ(count({1, 0, 1e-12, 0, 1, 0, 0, 0, 1}), 200 * 7 * 7);
    EXPECT_TRUE(std::isinf(count({1, 0, -1 / 4.5, 0, 1, 0, 0, 0, 1}))); // w is 0 at x = 4.5
}

// All multiples of a matrix are the same map; by powers of two also the same bits.
TEST(Warp, AMatrixMayBeSmallAllOver) {
    const auto src = disc_picture();
    const ROI roi = window(0, 48, 0, 40);
    const Matrix larger(2, 0.25f, 0, -0.25f, 2, 0, 0, 0, 1);
    const Matrix smaller(0.5f, 0.25f, 0.001f, -0.25f, 0.5f, 0, 9, 0, 1); // OpenImageIO's own
    for (const Matrix& M : {larger, smaller}) {
        const auto wanted = bytes(warped(src, M, roi));
        for (const int exponent : {-36, -100, 30})
            EXPECT_EQ(bytes(warped(src, M * std::ldexp(1.0f, exponent), roi)), wanted) << exponent;
    }
    ddt::Projective inverse;
    EXPECT_FALSE(ddt::Projective{{}}.invert(inverse));
    EXPECT_FALSE(
        (ddt::Projective{{1e-11, 1e-11, 0, 1e-11, 1e-11, 0, 0, 0, 1e-11}}.invert(inverse)));
    // Small beside the shift alone.
    EXPECT_TRUE((ddt::Projective{{1e-6, 0, 0, 0, 1e-6, 0, 1e9, 0, 1}}.invert(inverse)));
}

// OpenImageIO would filter them, for days.
TEST(Warp, ShrinkingWithoutEndIsRefused) {
    const auto src = disc_picture();
    for (const Matrix& M :
         {Matrix(1e-6f, 0, 0, 0, 1e-6f, 0, 0, 0, 1), Matrix(1, 0, 1 / 4.5f, 0, 1, 0, 0, 0, 1),
          // Nearly singular: 2^25 pixels by its inverse, 2^58 by that in float32.
          Matrix(-2.23260498f, -78.7316895f, 0.0274667889f, -1166.50916f, -41136.3555f, 14.3510618f,
                 0.00255160267f, -0.052307345f, 0.000229947676f)}) {
        ImageBuf dst;
        EXPECT_FALSE(ddt::warp(dst, src, M, {}, false, ImageBuf::WrapDefault, window(0, 9, 0, 9)));
        EXPECT_NE(dst.geterror().find("would not end"), std::string::npos);
        EXPECT_FALSE(dst.initialized());
    }
}

TEST(Warp, ReachHoldsEveryPixelItShows) {
    const ddt::Rect source{0, 0, 64, 64}, output{-100, -100, 300, 300};
    for (const auto& m : {std::array<double, 9>{2, 0.5, 0, -0.5, 2, 0, 5, 5, 1},
                          std::array<double, 9>{4, 0, 0.003, 0, 4, 0.002, -20, 0, 1},
                          std::array<double, 9>{-3, 0, 0, 0, 3, 0, 150, 0, 1}}) {
        const ddt::Projective to_output{m};
        ddt::Projective to_source;
        ASSERT_TRUE(to_output.invert(to_source));
        const ddt::MatrixMapping mapping(to_source, to_output, source, source, output);
        for (const auto& [x0, y0] : {std::pair(0, 0), std::pair(20, 50), std::pair(50, 3)}) {
            const ddt::Rect reach = mapping.reach(x0, y0, x0 + 13.0, y0 + 13.0);
            std::vector<ddt::Position> p(400);
            std::vector<uint8_t> inside(400);
            for (int y = output.y0; y < output.y1; ++y) {
                mapping.row(y, output.x0, output.x1, p.data(), inside.data());
                for (int i = 0; i < 400; ++i) {
                    const int x = output.x0 + i;
                    const auto& q = p[size_t(i)];
                    const bool shown = inside[size_t(i)] && q.x >= x0 * 65536 &&
                                       q.x < (x0 + 13) * 65536 && q.y >= y0 * 65536 &&
                                       q.y < (y0 + 13) * 65536;
                    const bool held =
                        x >= reach.x0 && x < reach.x1 && y >= reach.y0 && y < reach.y1;
                    ASSERT_TRUE(held || !shown) << x << " " << y;
                }
            }
        }
    }
}

} // namespace
