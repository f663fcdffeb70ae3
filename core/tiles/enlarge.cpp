#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <new>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/tiles/grid.h"
#include "core/tiles/tile_worker.h"
#include "ddt/core.h"

namespace ddt {

namespace {

/// Tiles in flight take no more than this together (or one tile's share, if that is more).
constexpr size_t memory_limit = size_t(192) << 20;

/// Largest coordinate of a window, so that positions and sites stay far from overflow.
constexpr int largest_coordinate = 1 << 29;

bool check(const Job& job, std::string& error) {
    const Rect& w = job.window;
    if (w.empty() || std::min(w.x0, w.y0) < -largest_coordinate ||
        std::max(w.x1, w.y1) > largest_coordinate)
        error = "ddt: the source window must not be empty, its coordinates within +-2^29";
    else if (job.channels < 1)
        error = "ddt: there must be at least 1 channel";
    else if (!job.kinds.empty() && job.kinds.size() != size_t(job.channels))
        error = "ddt: Job::kinds must be empty or have one entry a channel";
    else if (job.mesh.max_iterations < 0 || job.mesh.max_iterations > 250)
        error = "ddt: max_iterations must be 0 to 250";
    else if (job.surface.consistency < 0 || job.surface.consistency > 16)
        error = "ddt: consistency must be 0 to 16";
    else if (!(job.surface.limit >= 0) || !(job.surface.soft >= 0))
        error = "ddt: limit and soft must be 0 or more";
    return error.empty();
}

const char* describe(Outcome outcome) {
    switch (outcome) {
    case Outcome::done:
        return "";
    case Outcome::cancelled:
        return "ddt: cancelled";
    case Outcome::source_failed:
        return "ddt: the source could not be read";
    case Outcome::sink_failed:
        return "ddt: the result could not be written";
    case Outcome::bad_job:
        return "ddt: the job makes no sense";
    case Outcome::out_of_memory:
        return "ddt: out of memory";
    }
    return "ddt: unknown failure";
}

/// The state shared by the threads of one job.
class Run {
public:
    Run(const Job& job, int tiles) : m_job(job), m_tiles(tiles) {}

    bool going() const { return m_outcome.load(std::memory_order_relaxed) == Outcome::done; }
    void end(Outcome outcome) {
        auto expected = Outcome::done;
        m_outcome.compare_exchange_strong(expected, outcome);
    }
    void tile_done() {
        if (!m_job.progress)
            return;
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (going() && !m_job.progress(float(++m_done) / float(m_tiles)))
            end(Outcome::cancelled);
    }
    Outcome outcome() const { return m_outcome; }

private:
    const Job& m_job;
    const int m_tiles;
    std::atomic<Outcome> m_outcome{Outcome::done};
    std::mutex m_mutex;
    int m_done = 0;
};

Outcome run(Source& source, Sink& sink, const Mapping& mapping, const Job& job) {
    const Grid grid(job.window);
    Run state(job, grid.count());
    const size_t in_flight = std::max<size_t>(1, memory_limit / TileWorker::memory(job));
    int threads = job.threads > 0 ? job.threads : tbb::this_task_arena::max_concurrency();
    threads = int(std::min<size_t>(size_t(threads), in_flight));

    tbb::enumerable_thread_specific<std::unique_ptr<TileWorker>> workers;
    const auto work = [&](int index) {
        if (!state.going())
            return;
        auto& worker = workers.local();
        if (!worker)
            worker = std::make_unique<TileWorker>(source, sink, mapping, job);
        const Outcome outcome = worker->work(grid.tile(index));
        if (outcome == Outcome::done)
            state.tile_done();
        else
            state.end(outcome);
    };
    if (threads == 1) {
        for (int i = 0; i < grid.count(); ++i)
            work(i);
    } else {
        tbb::task_arena arena(threads);
        arena.execute([&] { tbb::parallel_for(0, grid.count(), work); });
    }
    if (job.statistics) {
        Statistics& sum = *job.statistics = {};
        for (const auto& worker : workers) {
            const Statistics& s = worker->statistics();
            sum.pixels += s.pixels;
            sum.evaluations += s.evaluations;
            sum.flips += s.flips;
            sum.rounds += s.rounds;
            sum.iterations = std::max(sum.iterations, s.iterations);
        }
    }
    return state.outcome();
}

} // namespace

Outcome enlarge(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                std::string* error) {
    Outcome outcome = Outcome::bad_job;
    std::string why;
    try {
        if (check(job, why))
            outcome = run(source, sink, mapping, job);
        if (outcome != Outcome::done && why.empty())
            why = describe(outcome);
    } catch (const std::bad_alloc&) {
        outcome = Outcome::out_of_memory;
        why = describe(outcome);
    } catch (const std::exception& e) {
        outcome = Outcome::bad_job;
        why = std::string("ddt: ") + e.what();
    }
    if (error)
        *error = why;
    return outcome;
}

} // namespace ddt
