// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/band_spans.h"

#include "core/tiles/tile_io.h"
#include "tests/core/job_helpers.h"
#include "tests/core/turned.h"

namespace ddt::test {
namespace {

constexpr Rect window{-5, 9, 195, 169};
constexpr double scale = 1.5;

struct Counts {
    int64_t looked_at = 0, served = 0;
};

/// Ask for all bands of the window's tile, and expect their pixels to be in their spans.
Counts count(const Turned& mapping, int rows) {
    const Tile tile = Grid(window).tile(0);
    std::vector<int> written(mapping.out().area(), 0);
    BandSpans spans;
    spans.begin(mapping.out());
    Counts counts;
    const Rect& c = tile.cells;
    for (int y0 = c.y0; y0 < c.y1; y0 += rows) {
        const Tile band = with_cells(tile, {c.x0, y0, c.x1, std::min(y0 + rows, c.y1)});
        spans.find(band, window, mapping);
        for (int y = spans.y0(); y < spans.y1(); ++y) {
            const BandSpans::Span span = spans.row(y);
            BandSpans::Span later{span.x1, span.x0};
            for (int x = span.x0; x < span.x1; ++x) {
                Position p;
                uint8_t inside = 0;
                mapping.row(y, x, x + 1, &p, &inside);
                ++counts.looked_at;
                if (inside && serves_below(band, p))
                    later = {std::min(later.x0, x), x + 1};
                if (!inside || !serves(band, p))
                    continue;
                ++counts.served;
                ++written[size_t(y - mapping.out().y0) * size_t(mapping.out().width()) +
                          size_t(x - mapping.out().x0)];
            }
            if (!span.empty() && spans.holds_rest(y))
                spans.leave(y, later);
        }
    }
    const Rect out = mapping.out();
    for (int y = out.y0, i = 0; y < out.y1; ++y)
        for (int x = out.x0; x < out.x1; ++x, ++i) {
            Position p;
            uint8_t inside = 0;
            mapping.row(y, x, x + 1, &p, &inside);
            EXPECT_EQ(written[size_t(i)], int(inside)) << x << ", " << y;
            if (written[size_t(i)] != int(inside))
                return counts;
        }
    return counts;
}

TEST(BandSpans, HoldAllOfABandAndLittleElse) {
    for (const double degrees : {0.0, 7.0, 45.0, 90.0, 133.0, 180.0, -60.0})
        for (const int rows : {8, 32, 200}) {
            SCOPED_TRACE(::testing::Message() << degrees << ", " << rows);
            const Turned mapping(window, degrees, scale);
            const Counts counts = count(mapping, rows);
            EXPECT_GT(counts.served, 60000);
            // Of bands as high as the blocks whose reach is asked for, or higher.
            if (rows >= 32) {
                EXPECT_LE(counts.looked_at, counts.served * 19 / 10);
            }
        }
}

TEST(BandSpans, OfAMappingThatReachesAllLookAtWhatIsLeft) {
    const Turned mapping(window, 30, scale, false);
    const Counts counts = count(mapping, 32);
    // All once, and then, by rows, from the first that is left to the last.
    const int64_t bands = 5;
    EXPECT_LE(counts.looked_at, int64_t(mapping.out().area()) + counts.served * bands / 2);
}

} // namespace
} // namespace ddt::test
