// SPDX-License-Identifier: Apache-2.0
// The tiles of one job on a GPU.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/gl/context/gpu.h"
#include "core/gl/host_tile.h"
#include "core/gl/stages.h"
#include "core/gl/strip.h"
#include "core/tiles/grid.h"
#include "core/tiles/run.h"
#include "ddt/core.h"

namespace ddt::gl {

/// Reads tiles ahead, gives them to the device several at a time, and writes what comes back, strip
/// by strip, while the device makes the next. Everything that touches GL is posted to its thread.
class Runner {
public:
    Runner(Gpu& gpu, Source& source, Sink& sink, const Mapping& mapping, const Job& job,
           const Grid& grid, int threads, Run& run);
    /// Waits for what was posted.
    ~Runner();

    /// Work until all tiles are done or the run has ended. Throws Failure.
    void work();

    /// Of the tiles that are done; filled in if the job or DDT_VERBOSE wants it.
    const Statistics& statistics() const { return m_statistics; }

private:
    struct JobTile : HostTile {
        int index = 0;
        Rect reach;
    };

    void read_ahead();
    void start_batch(); ///< on the context's thread
    void sample_batch();
    void sample(Strip& strip, Strip* write_meanwhile);
    void write(Strip& strip);
    void retry_with_fewer();
    void drop_meshes();
    void report();

    Gpu& m_gpu;
    Source& m_source;
    Sink& m_sink;
    const Mapping& m_mapping;
    const Job& m_job;
    const Grid& m_grid;
    Run& m_run;
    int m_threads;
    SlotShape m_shape;
    int m_meshes; ///< a tile; they take neighbouring slots
    Statistics m_statistics;

    int m_next_tile = 0;
    std::deque<std::unique_ptr<JobTile>> m_ready;  ///< read, not begun
    std::vector<std::unique_ptr<JobTile>> m_batch; ///< on the device
    size_t m_in_flight;                            ///< tiles a batch may have
    Strip m_strips[2];                             ///< one sampled while the other is written
    bool m_counting;                               ///< statistics are wanted

    // On the context's thread only.
    std::unique_ptr<DeviceMesh> m_mesh;
    std::unique_ptr<Surfaces> m_surfaces;
    std::unique_ptr<Stages> m_stages;
};

} // namespace ddt::gl
