// SPDX-License-Identifier: Apache-2.0
// What several cells of a starting mesh at once become is what each becomes.
#include "core/lattice/start_rows.h"

#include <cmath>

#include "core/guide/contour.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// Which diagonal a cell has, by the words of Lattice::start().
bool goes_down(const Lattice& lattice, int x, int y, bool flat, bool contours) {
    const auto z = [&](int dx, int dy) {
        return lattice.guide(lattice.vertex_site(x + dx, y + dy));
    };
    const int along = contour_xy(lattice.vertex(lattice.vertex_site(x, y)).contour);
    if (flat && contours && along != 0)
        return along < 0;
    return !flat || std::fabs(z(0, 0) - z(1, 1)) <= std::fabs(z(1, 0) - z(0, 1));
}

TEST(StartRows, AreTheSameOnEveryInstructionSetAndWhatIsSaid) {
    int along_contours = 0, cells = 0;
    on_each_target([&] {
        uint64_t seed = 11;
        for (int width = 2; width < 40; ++width)
            for (const int height : {2, 3, 7})
                for (const bool flat : {false, true})
                    for (const bool contours : {false, true}) {
                        // Few different numbers: ties, and cells without a contour.
                        const Kind kind = width % 2 ? Kind::few : Kind::noise;
                        const auto guide = make_guide(kind, width, height, ++seed);
                        Lattice lattice;
                        lattice.start(width, height, guide.data(), flat, contours);
                        ASSERT_TRUE(is_triangulation(lattice)) << width << " x " << height;
                        for (int y = 0; y < height; ++y)
                            for (int x = 0; x < width; ++x) {
                                const Vertex& vertex = lattice.vertex(lattice.vertex_site(x, y));
                                ASSERT_EQ(bits_of(vertex.guide),
                                          bits_of(guide[size_t(y * width + x)]));
                                if (!contours || x == width - 1 || y == height - 1) {
                                    ASSERT_EQ(vertex.contour, 0u);
                                }
                                // Edges run to the right or downwards, uprights and diagonals down.
                                if (x < width - 1) {
                                    ASSERT_EQ(lattice.edge(lattice.site(2 * x + 1, 2 * y)).v,
                                              Vec(1, 0));
                                }
                                if (y < height - 1) {
                                    ASSERT_EQ(lattice.edge(lattice.site(2 * x, 2 * y + 1)).v,
                                              Vec(0, 1));
                                }
                                if (x == width - 1 || y == height - 1)
                                    continue;
                                const bool down = goes_down(lattice, x, y, flat, contours);
                                ASSERT_EQ(lattice.edge(lattice.site(2 * x + 1, 2 * y + 1)).v,
                                          Vec(down ? 1 : -1, 1))
                                    << x << ' ' << y << " of " << width << " x " << height;
                                along_contours += down != goes_down(lattice, x, y, flat, false);
                                ++cells;
                            }
                    }
    });
    EXPECT_GT(cells, 10000);
    EXPECT_GT(along_contours, 100);
}

} // namespace
} // namespace ddt::test
