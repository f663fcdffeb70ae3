// SPDX-License-Identifier: Apache-2.0
// The tiles of one job on a GPU.
#pragma once

#include <deque>
#include <future>
#include <memory>
#include <vector>

#include "core/gl/gpu.h"
#include "core/gl/host_tile.h"
#include "core/gl/stage_timer.h"
#include "core/gl/strip.h"
#include "core/tiles/job_state.h"
#include "core/tiles/tiled_job.h"
#include "ddt/core.h"

namespace ddt::gl {

/// Reads tiles ahead, gives them to the device several at a time, and writes what comes back, some
/// strips at a time, while the device makes the next ones. Everything that touches GL is posted to
/// its thread, where nothing waits for the device but for what is then written.
class Runner {
public:
    Runner(Gpu& gpu, const TiledJob& tiled, Transfer transfer, JobState& state);
    /// Waits for what was posted.
    ~Runner();

    /// Work until all tiles are done or the job has ended. Throws Failure.
    void work();

    /// Of the tiles that are done; filled in if the job or DDT_VERBOSE wants it.
    const Statistics& statistics() const { return m_statistics; }

private:
    struct JobTile : HostTile {
        int index = 0;
        Rect reach;
    };
    /// A strip on its way through the device.
    struct JobStrip : Strip {
        std::shared_ptr<JobTile> tile;
        bool last = false;   ///< of its tile
        SampleMemory memory; ///< on the device
        std::unique_ptr<HostBuffer> results;
        std::shared_future<void> sampled; ///< all is asked of the device
        std::unique_ptr<Fence> copied;    ///< passed when the results are there
    };

    void read_ahead();
    void begin_batch(); ///< on the context's thread, as is finish_batch()
    void finish_batch();
    void sample_batch();
    JobStrip& next_strip();
    void make_room(JobStrip& strip);
    void sample(JobStrip& strip);
    void write_strips(size_t left);
    void write(size_t count);
    void wrote(const JobStrip& strip);
    void retry_with_fewer();
    void take_memory();
    void drop_meshes();
    void report();
    size_t result_count(const Strip& strip) const {
        return size_t(strip.plan.count) * size_t(m_job.channels);
    }

    Gpu& m_gpu;
    Source& m_source;
    Sink& m_sink;
    const Mapping& m_mapping;
    const Job& m_job;
    const Grid& m_grid;
    JobState& m_state;
    int m_threads;
    SlotShape m_shape;
    int m_meshes; ///< a tile; they take neighbouring slots
    Transfer m_transfer;
    Statistics m_statistics;

    int m_next_tile = 0;
    std::deque<std::shared_ptr<JobTile>> m_ready;      ///< read, not begun
    std::vector<std::shared_ptr<JobTile>> m_batch;     ///< on the device
    std::vector<std::unique_ptr<HostBuffer>> m_memory; ///< for tiles that are to be read
    std::vector<ReadMemory> m_read_memory;             ///< a thread
    size_t m_in_flight;                                ///< tiles a batch may have
    std::deque<std::unique_ptr<JobStrip>> m_under_way; ///< sampled, copied, to be written
    std::vector<std::unique_ptr<JobStrip>> m_spare;    ///< strips whose memory can be had
    size_t m_most_strips;                              ///< that are under way
    size_t m_strips_a_write;                           ///< of those, at most
    float m_strength;                                  ///< correction_strength()
    bool m_counting;                                   ///< statistics are wanted

    // On the context's thread only.
    std::unique_ptr<DeviceMesh> m_mesh;
    std::unique_ptr<Surfaces> m_surfaces;
    std::unique_ptr<StageTimer> m_timer;
    size_t m_uploaded = 0, m_downloaded = 0; ///< bytes
    int m_waits = 0;                         ///< for the device
};

} // namespace ddt::gl
