// SPDX-License-Identifier: Apache-2.0
// Tiles from source pixels to output pixels.
#pragma once

#include "core/tiles/rows_left.h"
#include "core/tiles/stage_clock.h"
#include "core/tiles/tile_memory.h"
#include "core/tiles/tile_writer.h"
#include "ddt/core.h"

namespace ddt {

/// What a thread needs to work on tiles beside the memory of their meshes, kept from one tile to
/// the next.
class TileWorker {
public:
    /// state: as TileWriter's.
    TileWorker(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
               JobState* state = nullptr)
        : m_source(source), m_mapping(mapping), m_job(job),
          m_writer(sink, mapping, job, m_statistics.times, m_arena, state) {}
    TileWorker(const TileWorker&) = delete;
    TileWorker& operator=(const TileWorker&) = delete;

    /// Read, triangulate, sample and write the tile's output rows from first_row on; nothing if the
    /// mapping shows none of it.
    Outcome work(const Tile& tile, int first_row);

    // The same in two steps, between which, and while the second is done, others may take rows.

    /// Read the tile and triangulate it, in `memory`, which must stay until all of it is written.
    /// index: the tile's in the job's grid.
    Outcome begin(const Tile& tile, int index, int first_row, TileMemory& memory);
    /// Write what is left of what was begun or taken.
    Outcome finish();
    /// Rows that are left, if they are enough for two; else 0.
    int rows_to_share() const { return m_left.to_share(); }
    /// Take half of the rows that somebody else has left, of a tile that must stay there until
    /// finish() is done. False if they are not enough for two.
    bool take_from(TileWorker& other) { return other.m_left.give(m_left); }

    const Statistics& statistics() const { return m_statistics; }

    /// About the bytes that a worker takes for a job.
    static size_t memory(const Job& job, const Mapping& mapping);

private:
    bool read(const Tile& tile, TileMemory& memory);
    void triangulate(const Tile& tile, TileMemory& memory);

    Source& m_source;
    const Mapping& m_mapping;
    const Job& m_job;
    Statistics m_statistics;
    StageClock m_clock;

    Arena m_arena; ///< the lists of triangulate(), and then the rows of m_writer
    RowsLeft m_left;
    TileWriter m_writer;
};

} // namespace ddt
