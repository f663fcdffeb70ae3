// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/work_on_cpu.h"

#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/parallel.h"
#include "core/tiles/tile_io.h"
#include "core/tiles/tile_worker.h"

namespace ddt {

namespace {

/// Workers together take no more than the first, and the second for every thread that is asked for
/// beyond a few; times the meshes. One there is in any case.
constexpr size_t memory_limit = size_t(200) << 20;
constexpr size_t memory_per_thread = size_t(22) << 20;
constexpr size_t few_threads = 16;

/// Output pixels that are worth a thread, where there are fewer tiles than threads.
constexpr size_t pixels_a_thread = size_t(1) << 16;

/// How many can work at the same time.
size_t member_count(const Mapping& mapping, const Job& job, const Grid& grid, size_t threads) {
    const size_t beyond = threads - std::min(threads, few_threads);
    const size_t limit = (memory_limit + beyond * memory_per_thread) * size_t(job.mesh.meshes);
    const size_t fitting = limit / TileWorker::memory(job, mapping.separable());
    const size_t useful =
        std::max(size_t(grid.count()), output_of(mapping).area() / pixels_a_thread);
    return std::max<size_t>(1, std::min({fitting, useful, threads}));
}

/// The threads of one job.
class Crew {
public:
    Crew(Source& source, Sink& sink, const Mapping& mapping, const Job& job, const Grid& grid,
         Run& run, size_t members)
        : m_source(source), m_sink(sink), m_mapping(mapping), m_job(job), m_grid(grid), m_run(run),
          m_members(members) {}

    void work() {
        const int members = int(m_members.size());
        for_each_index(members, members, [&](int slot, int) { work(m_members[size_t(slot)]); });
    }

    Statistics statistics() const {
        Statistics sum;
        for (const Member& member : m_members)
            if (member.worker)
                sum += member.worker->statistics();
        return sum;
    }

private:
    struct Member {
        std::unique_ptr<TileWorker> worker;
        bool working = false;
        Member* host = nullptr; ///< whose tile the member works on
        int tile = 0;           ///< the one this member began last,
        int parts = 0;          ///< and the members that work on it
    };

    void work(Member& self) {
        try {
            if (!self.worker)
                self.worker = std::make_unique<TileWorker>(m_source, m_sink, m_mapping, m_job);
            while (begin_tile(self) || take_part(self))
                finish(self);
        } catch (...) {
            m_run.end(Outcome::bad_job);
            stop_working(self);
            throw;
        }
    }

    /// Begin the next tile. False if there is none.
    bool begin_tile(Member& self) {
        if (!next_tile(self))
            return false;
        if (const Outcome outcome =
                self.worker->begin(m_grid.tile(self.tile), m_run.next_row(self.tile));
            outcome != Outcome::done)
            m_run.end(outcome);
        // Those that wait for rows have looked before they waited, or look now.
        { const std::lock_guard<std::mutex> lock(m_mutex); }
        m_changed.notify_all();
        return true;
    }

    bool next_tile(Member& self) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        while (m_next_tile < m_grid.count() && m_run.is_done(m_next_tile))
            ++m_next_tile;
        if (m_next_tile == m_grid.count() || !m_run.going())
            return false;
        self.tile = m_next_tile++;
        self.parts = 0;
        start_working(self, self);
        return true;
    }

    /// Wait for rows of another's tile. False if there will be none. All tiles were begun, so that
    /// hosts stay what they are.
    bool take_part(Member& self) {
        std::unique_lock<std::mutex> lock(m_mutex);
        while (m_run.going()) {
            if (Member* other = most_left()) {
                // It may have gone on meanwhile.
                if (!self.worker->take_from(*other->worker))
                    continue;
                start_working(self, *other->host);
                return true;
            }
            if (m_working == 0)
                return false;
            m_changed.wait(lock);
        }
        return false;
    }

    /// Who has the most rows to give away, if anybody has.
    Member* most_left() {
        Member* found = nullptr;
        int most = 0;
        for (Member& other : m_members)
            if (const int rows = other.working ? other.worker->rows_to_share() : 0; rows > most) {
                most = rows;
                found = &other;
            }
        return found;
    }

    /// On the host's tile.
    void start_working(Member& self, Member& host) {
        self.working = true;
        self.host = &host;
        ++host.parts;
        ++m_working;
    }

    void finish(Member& self) {
        if (m_run.going())
            if (const Outcome outcome = self.worker->finish(); outcome != Outcome::done)
                m_run.end(outcome);
        const int tile = self.host->tile;
        if (stop_working(self) && m_run.going())
            m_run.tile_done(tile);
    }

    /// Returns whether nobody works on the tile any more.
    bool stop_working(Member& self) {
        bool last = false;
        {
            const std::lock_guard<std::mutex> lock(m_mutex);
            if (self.working) {
                self.working = false;
                --m_working;
                last = --self.host->parts == 0;
            }
        }
        m_changed.notify_all();
        return last;
    }

    Source& m_source;
    Sink& m_sink;
    const Mapping& m_mapping;
    const Job& m_job;
    const Grid& m_grid;
    Run& m_run;
    std::mutex m_mutex; ///< of all that follows
    std::condition_variable m_changed;
    std::vector<Member> m_members;
    int m_next_tile = 0;
    int m_working = 0; ///< members
};

} // namespace

void work_on_cpu(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                 const Grid& grid, int threads, Run& run, Statistics& statistics) {
    Crew crew(source, sink, mapping, job, grid, run,
              member_count(mapping, job, grid, size_t(threads)));
    crew.work();
    statistics += crew.statistics();
}

} // namespace ddt
