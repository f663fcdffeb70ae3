// SPDX-License-Identifier: Apache-2.0
// How far a job is.
#pragma once

#include <atomic>
#include <climits>
#include <mutex>
#include <vector>

#include "ddt/core.h"

namespace ddt {

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

    void tile_done(int tile) {
        wrote_rows_before(INT_MAX, tile);
        if (!m_job.progress)
            return;
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (going() && !m_job.progress(float(++m_done) / float(m_next_row.size())))
            end(Outcome::cancelled);
    }

private:
    const Job& m_job;
    std::atomic<Outcome> m_outcome{Outcome::done};
    std::vector<int> m_next_row; ///< a tile
    std::mutex m_mutex;
    int m_done = 0;
};

} // namespace ddt
