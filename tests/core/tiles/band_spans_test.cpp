// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/band_spans.h"

#include <cmath>

#include "core/tiles/tile_io.h"
#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

constexpr Rect window{-5, 9, 195, 169};
constexpr double scale = 1.5;

/// The window turned round its first corner and enlarged. tight: reach() holds little else than is
/// asked for; if not, all there is.
class Turn final : public Mapping {
public:
    Turn(double degrees, bool tight)
        : m_cos(std::cos(degrees * M_PI / 180)), m_sin(std::sin(degrees * M_PI / 180)),
          m_out(corners(window.x0, window.y0, window.x1, window.y1)), m_tight(tight) {}

    Rect reach(double x0, double y0, double x1, double y1) const override {
        const Rect r = corners(std::max(x0, window.x0 - 1.0), std::max(y0, window.y0 - 1.0),
                               std::min(x1, window.x1 + 1.0), std::min(y1, window.y1 + 1.0));
        return m_tight ? Rect{std::max(r.x0, m_out.x0), std::max(r.y0, m_out.y0),
                              std::min(r.x1, m_out.x1), std::min(r.y1, m_out.y1)}
                       : m_out;
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        for (int x = x0; x < x1; ++x, ++positions, ++inside) {
            const double sx = (m_cos * x + m_sin * y) / scale, sy = (m_cos * y - m_sin * x) / scale;
            *positions = {int64_t(std::floor(sx * position_one)),
                          int64_t(std::floor(sy * position_one))};
            *inside =
                sx >= window.x0 && sx <= window.x1 - 1 && sy >= window.y0 && sy <= window.y1 - 1;
        }
    }
    Rect out() const { return m_out; }

private:
    Rect corners(double x0, double y0, double x1, double y1) const {
        double least_x = 1e9, least_y = 1e9, most_x = -1e9, most_y = -1e9;
        for (const double x : {x0, x1})
            for (const double y : {y0, y1}) {
                const double to_x = scale * (m_cos * x - m_sin * y),
                             to_y = scale * (m_sin * x + m_cos * y);
                least_x = std::min(least_x, to_x), most_x = std::max(most_x, to_x);
                least_y = std::min(least_y, to_y), most_y = std::max(most_y, to_y);
            }
        return {int(std::floor(least_x)), int(std::floor(least_y)), int(std::ceil(most_x)) + 1,
                int(std::ceil(most_y)) + 1};
    }

    double m_cos, m_sin;
    Rect m_out;
    bool m_tight;
};

struct Counts {
    int64_t looked_at = 0, served = 0;
};

/// Ask for all bands of the window's tile, and expect their pixels to be in their spans.
Counts count(const Turn& mapping, int rows) {
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
            const Turn mapping(degrees, true);
            const Counts counts = count(mapping, rows);
            EXPECT_GT(counts.served, 60000);
            // Of bands as high as the blocks whose reach is asked for, or higher.
            if (rows >= 32) {
                EXPECT_LE(counts.looked_at, counts.served * 19 / 10);
            }
        }
}

TEST(BandSpans, OfAMappingThatReachesAllLookAtWhatIsLeft) {
    const Turn mapping(30, false);
    const Counts counts = count(mapping, 32);
    // All once, and then, by rows, from the first that is left to the last.
    const int64_t bands = 5;
    EXPECT_LE(counts.looked_at, int64_t(mapping.out().area()) + counts.served * bands / 2);
}

} // namespace
} // namespace ddt::test
