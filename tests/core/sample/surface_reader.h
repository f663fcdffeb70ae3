// SPDX-License-Identifier: Apache-2.0
// Values of a surface over a scene.
#pragma once

#include <algorithm>

#include "core/base/float_mode.h"
#include "core/sample/evaluate.h"
#include "tests/core/helpers.h"
#include "tests/core/surface/scene.h"
#include "tests/core/surface/whole_net.h"

namespace ddt::test {

/// A surface over a scene: nets of all its channels.
class SurfaceReader {
public:
    SurfaceReader(const Scene& scene, Surface surface, const std::vector<float>& values,
                  int channels = 1, NearestMask nearest = 0, float tau = 0,
                  Bounds bounds = Bounds::vertices)
        : m_scene(scene), m_surface(surface), m_channels(channels), m_nearest(nearest) {
        const DenormalsAreZero zero;
        WholeEdges edges;
        for (int c = 0; c < channels; c += group_size) {
            m_nets.emplace_back();
            m_nets.back().bounds = bounds;
            set_all_vertices(scene.lattice,
                             {values.data(), channels, c, std::min(group_size, channels - c)},
                             m_nets.back());
            const bool bend = surface == Surface::patch, soft = tau > 0;
            if (bend || soft)
                edges.make(scene.lattice, scene.all(), bend, soft, tau, m_nets.back());
        }
        m_search.begin();
    }

    /// The channels at n positions that neighbour one another. What was located before may speed
    /// it up but not change it; `fresh`: nothing was.
    std::vector<float> row(const Point* points, int n, bool fresh = false) {
        const DenormalsAreZero zero;
        Search none;
        none.begin();
        LocatedRow& located = m_row;
        locate_row(m_scene.lattice, points, n, fresh ? none : m_search, located);
        const size_t size = size_t(n) * size_t(m_channels);
        constexpr float canary = -77.0f;
        std::vector<float> out(size + row_padding + 1, canary);
        for (int g = 0; g < int(m_nets.size()); ++g)
            evaluate_row(m_nets[size_t(g)], m_surface,
                         g < 8 ? m_nearest >> (g * group_size) & 15 : 0, located,
                         output_of(g, out.data(), 0));
        EXPECT_EQ(out.back(), canary);
        out.resize(size);
        return out;
    }
    float at(Point p) { return row(&p, 1)[0]; }

    /// The channels at all combinations of ascending x and y, by blocks of rows.
    std::vector<float> grid(const std::vector<int32_t>& x, const std::vector<int32_t>& y) {
        const DenormalsAreZero zero;
        Search search;
        search.begin();
        std::vector<Point> points;
        for (const int32_t px : x)
            points.push_back({px, 0});
        Columns columns;
        columns.find(points.data(), int(points.size()), m_scene.lattice.width());
        m_alike = columns.alike;
        m_blocks = m_together = m_crossed = m_mixed = 0;
        const size_t width = x.size() * size_t(m_channels), row = width + 3;
        constexpr float canary = -77.0f;
        std::vector<float> out(row * y.size(), canary);
        LocatedBlock block;
        for (size_t at = 0; at < y.size();) {
            const int rows = locate_block(m_scene.lattice, columns, points, y.data() + at,
                                          int(y.size() - at), search, block);
            EXPECT_GT(rows, 0);
            ++m_blocks;
            m_together += block.phases;
            m_crossed += !block.crossed.cells.empty();
            m_mixed += block.phases && !block.crossed.cells.empty();
            for (int g = 0; g < int(m_nets.size()); ++g)
                evaluate_block(m_nets[size_t(g)], m_surface, columns, block,
                               output_of(g, out.data() + at * row, row));
            at += size_t(rows);
        }
        std::vector<float> values;
        for (size_t at = 0; at < out.size(); at += row) {
            const auto begin = out.begin() + ptrdiff_t(at), end = begin + ptrdiff_t(width);
            values.insert(values.end(), begin, end);
            for (size_t i = width; i < row; ++i)
                EXPECT_EQ(out[at + i], canary); // what is between the rows is not the block's
        }
        return values;
    }

    /// Of the last grid(); of how many blocks they were evaluated together, of how many the
    /// crossed cells, and of how many both.
    const Columns::Alike& alike() const { return m_alike; }
    int blocks() const { return m_blocks; }
    int together() const { return m_together; }
    int crossed() const { return m_crossed; }
    int mixed() const { return m_mixed; }

private:
    GroupOutput output_of(int group, float* out, size_t row) const {
        const int first = group * group_size;
        return {out, row, m_channels, first, std::min(group_size, m_channels - first)};
    }

    const Scene& m_scene;
    Columns::Alike m_alike;
    int m_blocks = 0, m_together = 0, m_crossed = 0, m_mixed = 0;
    Surface m_surface;
    int m_channels;
    NearestMask m_nearest;
    std::vector<ControlNet> m_nets;
    Search m_search;
    LocatedRow m_row;
};

} // namespace ddt::test
