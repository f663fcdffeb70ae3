// SPDX-License-Identifier: Apache-2.0
// The thread that a GL context lives on.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>

namespace ddt::gl {

/// Runs functions one after the other on a thread of its own. Thread-safe. Meant to be leaked: the
/// thread sleeps until the process ends.
class Thread {
public:
    Thread();
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    /// Run f there; the future has its result or exception.
    template <class F>
    auto post(F f) -> std::future<decltype(f())> {
        auto task = std::make_shared<std::packaged_task<decltype(f())()>>(std::move(f));
        auto result = task->get_future();
        push([task] { (*task)(); });
        return result;
    }

private:
    void push(std::function<void()> f);
    void run();

    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<std::function<void()>> m_queue;
};

} // namespace ddt::gl
