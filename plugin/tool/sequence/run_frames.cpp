// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/sequence/run_frames.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>

#include "plugin/image/memory.h"
#include "plugin/tool/command/command.h"

namespace ddt::tool {

namespace {

/// Whether a frame was made. An empty file is none of ours, but of who keeps a place.
bool is_there(const std::string& path) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::is_directory(status))
        return false;
    return std::filesystem::exists(status) && (!std::filesystem::is_regular_file(status) ||
                                               std::filesystem::file_size(path, ignored) > 0);
}

class Queue {
public:
    Queue(const std::vector<FrameTask>& tasks, const FrameRun& run, Progress& progress)
        : m_tasks(tasks), m_run(run), m_progress(progress), m_shares(tasks.size()) {}

    /// Take frames until there are none left.
    void work() {
        std::unique_lock<std::mutex> lock(m_mutex);
        while (m_next < m_tasks.size() && !m_stopped) {
            const size_t index = m_next++;
            const FrameTask& task = m_tasks[index];
            // Others go on while a file system thinks.
            lock.unlock();
            const bool skipped = m_run.skip_existing && is_there(task.out) && is_made(task);
            const int64_t memory = skipped ? 0 : memory_of(task);
            lock.lock();
            if (skipped) {
                ++m_counts.skipped;
                show(index, 1);
                continue;
            }
            m_room.wait(lock,
                        [&] { return m_stopped || m_taken == 0 || m_taken + memory <= m_allowed; });
            if (m_stopped)
                return;
            m_taken += memory;
            lock.unlock();
            Failure failure;
            const bool done = attempt(task, index, failure);
            lock.lock();
            m_taken -= memory;
            done ? void(++m_counts.written) : note(failure);
            // Of a run that ends here nothing says that it was done.
            if (!m_stopped)
                show(index, 1);
            m_room.notify_all();
        }
    }

    FrameCounts counts() const { return m_counts; }

private:
    bool is_made(const FrameTask& task) const {
        try {
            return !m_run.is_made || m_run.is_made(task);
        } catch (const std::exception&) {
            return false; // the attempt tells
        }
    }

    int64_t memory_of(const FrameTask& task) const {
        try {
            return m_run.memory_of ? m_run.memory_of(task) : 0;
        } catch (const std::exception&) {
            return 0; // the attempt tells
        }
    }

    bool attempt(const FrameTask& task, size_t index, Failure& failure) {
        try {
            return m_run.run(
                task,
                [&](float share) {
                    const std::lock_guard<std::mutex> guard(m_mutex);
                    // The last hundredth is the file under its name.
                    show(index, 0.99f * share);
                    return true;
                },
                failure);
        } catch (const std::exception&) {
            failure = thrown();
            failure.why = "\"" + task.in + "\": " + failure.why;
        }
        return false;
    }

    void show(size_t index, float share) {
        m_total += double(share) - double(m_shares[index]);
        m_shares[index] = share;
        m_progress(float(m_total / double(m_tasks.size())));
    }

    void note(const Failure& failure) {
        ++m_counts.failed;
        m_progress.hide();
        fail(failure);
        if (m_counts.code == exit_done || failure.code == exit_resources)
            m_counts.code = failure.code;
        m_stopped = !m_run.keep_going;
    }

    const std::vector<FrameTask>& m_tasks;
    const FrameRun& m_run;
    Progress& m_progress;
    std::mutex m_mutex; ///< of all that follows
    std::condition_variable m_room;
    std::vector<float> m_shares;
    double m_total = 0;
    size_t m_next = 0;
    const int64_t m_allowed = memory_allowed();
    int64_t m_taken = 0;
    bool m_stopped = false;
    FrameCounts m_counts;
};

} // namespace

FrameCounts run_frames(const std::vector<FrameTask>& tasks, const FrameRun& run,
                       Progress& progress) {
    Queue queue(tasks, run, progress);
    std::vector<std::thread> threads;
    try {
        for (size_t i = 1; i < std::min(size_t(run.jobs), tasks.size()); ++i)
            threads.emplace_back([&] { queue.work(); });
    } catch (const std::exception&) { // no more threads: those that are there do it
    }
    queue.work();
    for (std::thread& thread : threads)
        thread.join();
    return queue.counts();
}

int64_t memory_allowed() {
    return available_memory() / 4 * 3;
}

} // namespace ddt::tool
