// SPDX-License-Identifier: Apache-2.0
#include "plugin/reader/pieces.h"

#include "tests/plugin/images.h"

namespace {

constexpr int tile = 64;

/// An image of several tiles of the mesh's grid, neither window at 0.
class PiecesTest : public testing::Test {
protected:
    PiecesTest() {
        m_source = images::make(images::window(-7, 593, 5, 405), images::window(-20, 600, 0, 410),
                                3, OIIO::TypeUInt8);
        images::fill(m_source, [](int x, int y, int c) {
            return float((x * x / 31 + y * y / 17 + x * y / 40 + 50 * c) & 127) / 255.0f;
        });
        m_options.statistics = &m_statistics;
    }

    /// What a reader declares, for a factor.
    void enlarge(double x, double y) {
        m_spec = m_source.spec();
        OIIO::set_roi_full(m_spec, images::window(-20, -20 + int(620 * x), 0, int(410 * y)));
        OIIO::set_roi(m_spec, images::window(-20 + int(13 * x), -20 + int(613 * x), int(5 * y),
                                             int(405 * y)));
        m_whole.reset(m_spec);
        ASSERT_TRUE(ddt::resize(m_whole, m_source, m_options, m_whole.roi())) << m_whole.geterror();
        m_all_pixels = m_statistics.pixels;
    }

    /// Read one tile and compare; returns how many pixels of mesh it took.
    int64_t read(ddt::Pieces& pieces, int x, int y) {
        const OIIO::ROI roi =
            OIIO::roi_intersection(images::window(x, x + tile, y, y + tile), m_whole.roi());
        const ddt::Rect r{roi.xbegin, roi.ybegin, roi.xend, roi.yend};
        std::vector<unsigned char> read(r.area() * 3), expected(r.area() * 3);
        m_statistics = {};
        std::string error;
        EXPECT_TRUE(pieces.read(r, 2, read.data(), size_t(r.width()) * 3, error)) << error;
        EXPECT_TRUE(m_whole.get_pixels(roi, OIIO::TypeUInt8, expected.data()));
        EXPECT_EQ(read, expected) << x << " " << y;
        return m_statistics.pixels;
    }

    OIIO::ImageBuf m_source, m_whole;
    OIIO::ImageSpec m_spec;
    ddt::Options m_options;
    ddt::Statistics m_statistics;
    int64_t m_all_pixels = 0;
};

TEST_F(PiecesTest, ATileTakesAPartOfTheMeshAndIsKept) {
    enlarge(4, 4);
    ddt::Pieces pieces(m_source, m_spec, m_options);
    const int64_t taken = read(pieces, m_spec.x + 640, m_spec.y + 640);
    EXPECT_GT(taken, 0);
    EXPECT_LE(taken, (256 + 2 * 33) * (256 + 2 * 33));
    EXPECT_EQ(read(pieces, m_spec.x + 640, m_spec.y + 640), 0);
    EXPECT_EQ(read(pieces, m_spec.x + 704, m_spec.y + 640), 0); // lies on the same tile of the mesh
}

TEST_F(PiecesTest, AllTilesTakeTheMeshOnce) {
    for (const auto& [across, down] : {std::pair{2.0, 2.0}, {4.0, 3.0}, {1.5, 2.5}}) {
        enlarge(across, down);
        ddt::Pieces pieces(m_source, m_spec, m_options);
        int64_t taken = 0;
        for (int y = m_spec.y; y < m_spec.y + m_spec.height; y += tile)
            for (int x = m_spec.x; x < m_spec.x + m_spec.width; x += tile)
                taken += read(pieces, x, y);
        EXPECT_EQ(taken, m_all_pixels) << across << " " << down;
    }
}

TEST_F(PiecesTest, KeepsNoMoreThanAllowed) {
    enlarge(3, 3);
    constexpr size_t most = size_t(3) << 20;
    ddt::Pieces pieces(m_source, m_spec, m_options, most);
    for (int y = m_spec.y; y < m_spec.y + m_spec.height; y += 4 * tile)
        for (int x = m_spec.x; x < m_spec.x + m_spec.width; x += 4 * tile) {
            read(pieces, x, y);
            EXPECT_LE(pieces.bytes_kept(), most);
        }
    EXPECT_GT(pieces.bytes_kept(), 0u);
}

TEST_F(PiecesTest, FactorsOfAllSizes) {
    for (const auto& [across, down] : {std::pair{0.25, 0.25}, {1.0, 1.0}, {0.5, 2.0}, {7.0, 1.0}}) {
        enlarge(across, down);
        ddt::Pieces pieces(m_source, m_spec, m_options);
        for (int x = m_spec.x; x < m_spec.x + m_spec.width; x += 3 * tile)
            read(pieces, x, m_spec.y + m_spec.height - 30);
    }
}

TEST_F(PiecesTest, HolesAreThoseOfTheWholeImage) {
    // A channel for alpha, which is 0 in two places on different tiles of the mesh.
    m_source.specmod().alpha_channel = 2;
    images::fill(m_source, [](int x, int y, int c) {
        const bool hole = (x / 8 == 12 && y / 8 == 20) || (x / 8 == 50 && y / 8 == 41);
        return c < 2 ? float((x * x / 31 + y * y / 17) & 127) / 255.0f : hole ? 0.0f : 1.0f;
    });
    m_options.holes = ddt::Holes::fill_alpha;
    enlarge(1.5, 1.5);
    ddt::Pieces pieces(m_source, m_spec, m_options);
    EXPECT_GT(read(pieces, m_spec.x + 320, m_spec.y + 192), 0);
    EXPECT_EQ(read(pieces, m_spec.x + 640, m_spec.y + 448), 0);
}

TEST_F(PiecesTest, AFailureStays) {
    enlarge(2, 2);
    m_options.progress = [](float) { return false; };
    ddt::Pieces pieces(m_source, m_spec, m_options);
    std::vector<unsigned char> out(3);
    std::string first, second;
    const ddt::Rect r{m_spec.x, m_spec.y, m_spec.x + 1, m_spec.y + 1};
    EXPECT_FALSE(pieces.read(r, 1, out.data(), 3, first));
    EXPECT_FALSE(pieces.read(r, 1, out.data(), 3, second));
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(first, second);
}

} // namespace
