// SPDX-License-Identifier: Apache-2.0
// One tile from source pixels to output pixels.
#pragma once

#include <vector>

#include "core/tiles/grid.h"
#include "core/tiles/stage_clock.h"
#include "core/tiles/tile_mesh.h"
#include "ddt/core.h"

namespace ddt {

/// The memory a thread needs to work on tiles, kept from one tile to the next.
class TileWorker {
public:
    TileWorker(Source& source, Sink& sink, const Mapping& mapping, const Job& job)
        : m_source(source), m_sink(sink), m_mapping(mapping), m_job(job) {}

    /// Read, triangulate, sample and write the tile's output rows from first_row on; nothing if the
    /// mapping shows none of it.
    Outcome work(const Tile& tile, int first_row);

    const Statistics& statistics() const { return m_statistics; }

    /// About the bytes that a worker takes for a job; `separable`: Mapping::separable().
    static size_t memory(const Job& job, bool separable);

private:
    /// Take the memory that the largest tile needs: a vector that grows from tile to tile would
    /// take up to twice of it.
    void reserve();
    bool read(const Tile& tile);
    const float* guide_of(size_t mesh); ///< to be called in ascending order
    void make_edges_for(int32_t y, int32_t keep);
    Outcome write(const Tile& tile, const Rect& reach);
    bool find_columns(const Tile& tile, const Rect& rows);
    template <class F>
    Outcome each_panel(const Rect& r, F&& f) const;
    Outcome write_rows(const Tile& tile, const Rect& rows, bool panels);
    static bool follows(const Point& a, const Point& b);
    Outcome write_runs(const Tile& tile, const Rect& row);
    void sample(int n, float* out);
    int sample_block(const int32_t* y, int n, float* out, size_t row);
    void join(size_t mesh, const float* last, size_t positions, float* mean) const;
    bool any_nearest() const;
    bool hand_over(const Rect& r); ///< m_out to the sink

    Source& m_source;
    Sink& m_sink;
    const Mapping& m_mapping;
    const Job& m_job;
    Statistics m_statistics;
    StageClock m_clock;

    std::vector<float> m_values, m_guide, m_blurred;
    int m_width = 0, m_height = 0; ///< of the lattice
    std::vector<TileMesh> m_meshes;
    Workspace m_workspace;
    std::vector<Position> m_positions;
    std::vector<uint8_t> m_inside;
    std::vector<Point> m_points;
    Columns m_columns; ///< where write_rows() is
    std::vector<int32_t> m_ys;
    std::vector<float> m_out;
    std::vector<float> m_last; ///< what a mesh adds to the mean
};

} // namespace ddt
