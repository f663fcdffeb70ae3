// SPDX-License-Identifier: Apache-2.0
// The output rows of a tile that was triangulated.
#pragma once

#include <algorithm>
#include <vector>

#include "core/sample/evaluate.h"
#include "core/tiles/band_spans.h"
#include "core/tiles/job_state.h"
#include "core/tiles/rows_left.h"
#include "core/tiles/stage_clock.h"
#include "core/tiles/tile_mesh.h"
#include "core/tiles/tile_surface.h"
#include "ddt/core.h"

namespace ddt {

/// Makes output pixels of tiles and hands them to the sink. Has the memory for that, kept from one
/// tile to the next.
class TileWriter {
public:
    /// arena: for rows of a tile's surface; it is cleared for each part that is written. state: is
    /// told what is written; where the job has ended, nothing more is; null: there is none.
    TileWriter(Sink& sink, const Mapping& mapping, const Job& job, StageTimes& times, Arena& arena,
               JobState* state);

    /// Write what is left of a tile. Where the job ends meanwhile, its outcome.
    Outcome write(RowsLeft& left);

    /// Whether the positions of a tile's output pixels are the points of a grid: y the same in a
    /// row, x in a column, both ascending, neighbours in a row so near that they can be followed.
    bool is_grid(const Tile& tile, const Rect& pixels);
    /// The fewest rows that are worth being made by a thread of their own, where `pixels` are made
    /// in `rows` rows.
    static int least_shared_rows(int rows, const Rect& pixels);

    /// Rows of cells that are worked on together where the output is no grid: with more of them
    /// runs of positions are longer, and more rows of the surface are kept.
    static int cells_in_band(int channels);

    /// About the bytes that this takes for a job, for lattices of width x height pixels.
    static MemoryNeeded memory(const Job& job, const Mapping& mapping, int width, int height);

private:
    void take_memory(const Rect& pixels);
    int32_t y_of(const Tile& tile, int y, int x) const;
    int whole_cells(const Rect& grid, int y, int rows) const;
    int rows_together(int height, size_t row) const;
    Tile part_of(const Tile& tile, const Rect& pixels) const;
    void make_edges_for(int32_t y, int32_t keep);
    void make_edges_for_row(int y);
    bool ascends(const Tile& tile, const Rect& row);
    void find_columns(const Tile& tile, const Rect& rows);
    /// Columns of output that are worked on at once: what is kept for each column stays small
    /// however long the rows are.
    static int panel_columns(const Job& job);
    /// Call f(panel) for parts of r that are no wider than a panel, from left to right, until it
    /// returns something else than `done`.
    template <class F>
    Outcome each_panel(const Rect& r, F&& f) const {
        const int columns = panel_columns(m_job);
        for (int x = r.x0; x < r.x1; x += columns) {
            const Outcome outcome =
                f(Rect{x, r.y0, r.x0 + std::min(x - r.x0 + columns, r.width()), r.y1});
            if (outcome != Outcome::done)
                return outcome;
        }
        return Outcome::done;
    }
    void begin_surfaces(const Tile& part, int cells);
    Outcome write_grid(RowsLeft& left);
    Outcome write_strip(const Rect& rows);
    Outcome write_rows(const Tile& tile, const Rect& rows);
    void place_rows(const Rect& rows, float* place, size_t row);
    Outcome write_bands(RowsLeft& left);
    Outcome write_band(const Tile& band);
    Outcome write_runs(const Tile& band, const Rect& row, BandSpans::Span* later);
    void sample(int n, float* out);
    int sample_block(const int32_t* y, int n, float* out, size_t row);
    void join(size_t mesh, const float* last, size_t positions, float* mean) const;
    bool hand_over(const Rect& r); ///< m_out to the sink
    Outcome wrote(const Rect& r);
    void report_written();
    Outcome outcome() const { return m_state ? m_state->outcome() : Outcome::done; }
    /// So many of the rows that are left; none once the job has ended.
    Rect take(RowsLeft& left, int rows) const {
        return outcome() == Outcome::done ? left.take(rows) : Rect();
    }

    Sink& m_sink;
    const Mapping& m_mapping;
    const Job& m_job;
    StageTimes& m_times;
    Arena& m_arena;
    JobState* m_state;
    StageClock m_clock;

    bool m_past_caches; ///< results are put where the sink has a place for them
    int m_rows_in_cell; ///< output rows in a row of cells, about
    const MeshedTile* m_meshed = nullptr;
    int64_t m_written = 0;               ///< numbers of its result that m_state was not told of yet
    std::vector<TileSurface> m_surfaces; ///< one a mesh
    std::vector<Position> m_positions;
    std::vector<uint8_t> m_inside;
    std::vector<Point> m_points;
    Columns m_columns;     ///< where write_rows() is
    bool m_panels = false; ///< a grid's rows are written in several panels, one after the other
    BandSpans m_spans;
    std::vector<int32_t> m_ys;
    std::vector<float> m_out;
    std::vector<float> m_last; ///< what a mesh adds to the mean
};

} // namespace ddt
