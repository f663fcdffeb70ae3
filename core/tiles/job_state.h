// SPDX-License-Identifier: Apache-2.0
// How far a job is.
#pragma once

#include <algorithm>
#include <atomic>
#include <climits>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

#include "ddt/core.h"

namespace ddt {

/// Progress is told whenever about so many more numbers of a tile's result are written: of smaller
/// ones once they are done.
constexpr int64_t told_numbers = int64_t(1) << 22;

/// The state shared by the threads of one job. Thread-safe, but for next_row() of a tile, which
/// belongs to whoever works on the tile.
class JobState {
public:
    JobState(const Job& job, int tiles) : m_job(job), m_next_row(size_t(tiles), INT_MIN) {}

    bool going() const { return m_outcome.load(std::memory_order_relaxed) == Outcome::done; }
    /// The first outcome that is not `done` counts.
    void end(Outcome outcome) {
        auto expected = Outcome::done;
        m_outcome.compare_exchange_strong(expected, outcome);
    }
    Outcome outcome() const { return m_outcome; }

    /// The first output row of the tile that was not written yet; no pixel is written twice.
    int next_row(int tile) const { return m_next_row[size_t(tile)]; }
    void wrote_rows_before(int row, int tile) { m_next_row[size_t(tile)] = row; }
    bool is_done(int tile) const { return next_row(tile) == INT_MAX; }

    /// So many more numbers of a tile's result, which has `all`, are written.
    void wrote(int64_t numbers, double all, int tile) {
        if (!m_job.progress)
            return;
        const std::lock_guard<std::mutex> lock(m_mutex);
        Part& part = m_parts[tile];
        const int64_t before = part.numbers;
        part.numbers += numbers;
        const auto units = int64_t(double(part.numbers) / all * double(units_of_tile));
        m_units += units - part.units;
        part.units = units;
        if (part.numbers / told_numbers != before / told_numbers)
            tell(std::min(share(), below_one));
    }

    void tile_done(int tile) {
        wrote_rows_before(INT_MAX, tile);
        if (!m_job.progress)
            return;
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_units += units_of_tile;
        if (const auto part = m_parts.find(tile); part != m_parts.end()) {
            m_units -= part->second.units;
            m_parts.erase(part);
        }
        tell(++m_done == m_next_row.size() ? 1.0f : std::min(share(), below_one));
    }

    /// To be called of a job that has no tile: nothing else tells that it is done.
    void nothing_to_do() {
        if (m_job.progress)
            tell(1);
    }

private:
    /// Shares are added up in whole numbers, so that they never fall.
    static constexpr int64_t units_of_tile = int64_t(1) << 20;
    /// Of tiles nothing but the last one's end is told as 1, whatever floats make of a share:
    /// others may have reported all that they wrote.
    static constexpr float below_one = 0x1.fffffep-1f;
    /// What is written of a tile that is not done.
    struct Part {
        int64_t numbers = 0, units = 0;
    };

    float share() const {
        return float(double(m_units) / (double(units_of_tile) * double(m_next_row.size())));
    }
    void tell(float share) {
        if (going() && !m_job.progress(share))
            end(Outcome::cancelled);
    }

    const Job& m_job;
    std::atomic<Outcome> m_outcome{Outcome::done};
    std::vector<int> m_next_row; ///< a tile
    std::mutex m_mutex;          ///< of all that follows
    std::map<int, Part> m_parts; ///< of large tiles
    int64_t m_units = 0;
    size_t m_done = 0; ///< tiles
};

} // namespace ddt
