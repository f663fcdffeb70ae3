// One tile from source pixels to output pixels.
#pragma once

#include <vector>

#include "core/sample/evaluate.h"
#include "core/surface/consistency.h"
#include "core/surface/edge_maker.h"
#include "core/surface/net.h"
#include "core/tiles/grid.h"
#include "core/tiles/stage_clock.h"
#include "core/triangulate/triangulate.h"
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

    /// About the bytes that a worker takes for a job.
    static size_t memory(const Job& job);

private:
    /// Take the memory that the largest tile needs: a vector that grows from tile to tile would
    /// take up to twice of it.
    void reserve();
    bool read(const Tile& tile);
    void triangulate_tile();
    void make_surface(const Tile& tile);
    void begin_edges(Net& net, const Rect& part);
    void make_edges_for(int32_t y);
    Outcome write(const Tile& tile, const Rect& reach);
    Outcome write_rows(const Tile& tile, const Rect& rows);
    Outcome write_runs(const Tile& tile, const Rect& row);
    void sample(int n, float* out);
    int sample_block(const int32_t* y, int n, float* out, size_t row);
    bool any_nearest() const;
    bool hand_over(const Rect& r); ///< m_out to the sink

    Source& m_source;
    Sink& m_sink;
    const Mapping& m_mapping;
    const Job& m_job;
    Statistics m_statistics;
    StageClock m_clock;

    std::vector<float> m_values, m_guide;
    int m_width = 0, m_height = 0; ///< of the lattice
    Lattice m_lattice;
    Workspace m_workspace;
    std::vector<Net> m_nets; ///< one a group of channels
    EdgeMaker m_edges;
    Consistency m_consistency;
    std::vector<Position> m_positions;
    std::vector<uint8_t> m_inside;
    std::vector<Point> m_points;
    Search m_search;
    LocatedRow m_row;  ///< where write_runs() is
    Columns m_columns; ///< where write_rows() is
    LocatedBlock m_block;
    std::vector<int32_t> m_ys;
    std::vector<float> m_out;
};

} // namespace ddt
