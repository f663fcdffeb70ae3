// SPDX-License-Identifier: Apache-2.0
// The thread that a GL context lives on.
#pragma once

#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace ddt::gl {

/// Runs functions one after the other on a thread of its own; what one of them asks for runs at
/// once. Thread-safe. Meant to be leaked: the thread sleeps until the process ends.
class Thread {
public:
    Thread();
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    /// Run f there; the future has its result or exception.
    template <class F>
    auto post(F f) -> std::future<decltype(f())> {
        auto task = std::make_unique<Posted<F>>(std::move(f));
        auto result = task->work.get_future();
        if (here())
            task->work();
        else
            push(*task.release()); // deletes itself
        return result;
    }

    /// Run f, which must not throw, there, and return when it has run. Takes no memory: for
    /// destructors, which may run because there is none.
    template <class F>
    void call(F f) noexcept {
        if (here())
            return f();
        Called<F> task(std::move(f));
        push(task);
        task.wait();
    }

private:
    /// A link of the queue. The thread that posts makes it, so that queueing cannot fail.
    struct Task {
        virtual ~Task() = default;
        /// The last thing done with the task: it may be gone afterwards.
        virtual void run() noexcept = 0;
        Task* next = nullptr;
    };

    template <class F>
    struct Posted final : Task {
        explicit Posted(F f) : work(std::move(f)) {}
        void run() noexcept override {
            work();
            delete this;
        }
        std::packaged_task<decltype(std::declval<F&>()())()> work;
    };

    template <class F>
    struct Called final : Task {
        explicit Called(F f) : work(std::move(f)) {}
        void run() noexcept override {
            work();
            const std::lock_guard<std::mutex> lock(mutex);
            done = true;
            changed.notify_one(); // under the lock: once it is free, the task may be gone
        }
        void wait() {
            std::unique_lock<std::mutex> lock(mutex);
            changed.wait(lock, [this] { return done; });
        }
        F work;
        bool done = false;
        std::mutex mutex;
        std::condition_variable changed;
    };

    bool here() const { return std::this_thread::get_id() == m_id; }
    void push(Task& task) noexcept;
    void run();

    std::thread::id m_id;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    Task* m_first = nullptr;
    Task** m_end = &m_first; ///< where the next task is linked
};

} // namespace ddt::gl
