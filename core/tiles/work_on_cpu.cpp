// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/work_on_cpu.h"

#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/tiles/crew_size.h"
#include "core/tiles/tile_memory.h"
#include "core/tiles/tile_order.h"
#include "core/tiles/tile_worker.h"

namespace ddt {

namespace {

/// The threads of one job.
class Crew {
public:
    Crew(const TiledJob& tiled, JobState& state, CrewSize size, NodeOfThread node)
        : m_source(tiled.source), m_sink(tiled.sink), m_mapping(tiled.mapping), m_job(tiled.job),
          m_grid(tiled.grid), m_state(state), m_node(node), m_places(size.places),
          m_members(size.members), m_order(m_grid.count(), m_grid.columns()) {}

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
    /// Where a tile is meshed, and stays until all of it is written.
    struct Place {
        std::optional<KeptMemory> memory;
        int node = -1; ///< of memory, that of the first thread that worked here; -1: none did
        int tile = 0;
        int number = 0; ///< of the tile, in the order in which tiles were begun
        int parts = 0;  ///< members that work on it; 0: it is free
    };
    struct Member {
        std::unique_ptr<TileWorker> worker;
        Place* place = nullptr; ///< that the member works at, if it does
    };
    enum class Next { begin, finish, none };

    void work(Member& self) {
        try {
            if (!self.worker)
                self.worker =
                    std::make_unique<TileWorker>(m_source, m_sink, m_mapping, m_job, &m_state);
            for (Next next = find_work(self); next != Next::none; next = find_work(self)) {
                if (next == Next::begin)
                    begin(self);
                finish(self);
            }
        } catch (...) {
            m_state.end(Outcome::bad_job);
            stop_working(self);
            throw;
        }
    }

    /// Begin a tile if there is a place for it, else take a part of another's; wait for either.
    Next find_work(Member& self) {
        const int node = m_node();
        std::unique_lock<std::mutex> lock(m_mutex);
        while (m_state.going()) {
            Place* const place = free_place(node);
            if (place && find_tile(node, place->tile)) {
                place->number = m_begun++;
                if (place->node < 0)
                    place->node = node;
                start_working(self, *place);
                return Next::begin;
            }
            const bool tiles = !m_order.empty();
            if (Member* other = whom_to_help(tiles, node)) {
                // It may have gone on meanwhile, but not to another place.
                if (!self.worker->take_from(*other->worker))
                    continue;
                start_working(self, *other->place);
                return Next::finish;
            }
            if (!tiles && m_working == 0)
                break;
            m_changed.wait(lock);
        }
        return Next::none;
    }

    /// The next tile that is not done; false: all are.
    bool find_tile(int node, int& tile) {
        while (!m_order.empty()) {
            tile = m_order.next(node);
            if (!m_state.is_done(tile))
                return true;
        }
        return false;
    }

    /// A free place: best one whose memory is near, else one that has none yet, else any; or null.
    Place* free_place(int node) {
        Place* found = nullptr;
        const auto near = [&](const Place& p) { return p.node == node ? 2 : p.node < 0 ? 1 : 0; };
        for (Place& place : m_places)
            if (place.parts == 0 && (!found || near(place) > near(*found)))
                found = &place;
        return found;
    }

    void begin(Member& self) {
        Place& place = *self.place;
        if (!place.memory)
            place.memory.emplace();
        if (const Outcome outcome = self.worker->begin(
                m_grid.tile(place.tile), place.tile, m_state.next_row(place.tile), **place.memory);
            outcome != Outcome::done)
            m_state.end(outcome);
        // Those that wait for rows have looked before they waited, or look now.
        { const std::lock_guard<std::mutex> lock(m_mutex); }
        m_changed.notify_all();
    }

    /// The member to take rows from, or null if none has rows to give away: rather one whose memory
    /// is near; then, where a tile waits for a place, one at the tile that was begun first; then
    /// the one with the most rows. Places get free one after the other this way: if all got free
    /// at once, there would be only meshes to make next, for fewer members than there are.
    Member* whom_to_help(bool tile_waits, int node) {
        Member* found = nullptr;
        std::array<int, 3> least{};
        for (Member& other : m_members) {
            const int rows = other.place ? other.worker->rows_to_share() : 0;
            if (rows == 0)
                continue;
            const std::array<int, 3> rank{other.place->node != node,
                                          tile_waits ? other.place->number : 0, -rows};
            if (!found || rank < least) {
                least = rank;
                found = &other;
            }
        }
        return found;
    }

    void start_working(Member& self, Place& at) {
        self.place = &at;
        ++at.parts;
        ++m_working;
    }

    void finish(Member& self) {
        if (m_state.going())
            if (const Outcome outcome = self.worker->finish(); outcome != Outcome::done)
                m_state.end(outcome);
        const int tile = self.place->tile;
        if (stop_working(self) && m_state.going())
            m_state.tile_done(tile);
    }

    /// Returns whether nobody works on the tile any more.
    bool stop_working(Member& self) {
        bool last = false;
        {
            const std::lock_guard<std::mutex> lock(m_mutex);
            if (self.place) {
                last = --self.place->parts == 0;
                self.place = nullptr;
                --m_working;
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
    JobState& m_state;
    const NodeOfThread m_node;
    std::mutex m_mutex; ///< of all that follows
    std::condition_variable m_changed;
    std::vector<Place> m_places;
    std::vector<Member> m_members;
    TileOrder m_order;
    int m_begun = 0;   ///< tiles
    int m_working = 0; ///< members
};

} // namespace

void work_on_cpu(const TiledJob& job, JobState& state, Statistics& statistics, NodeOfThread node) {
    Crew crew(job, state, crew_size(job.mapping, job.job, job.grid, size_t(job.threads)), node);
    crew.work();
    statistics += crew.statistics();
}

} // namespace ddt
