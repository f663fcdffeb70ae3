// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/thread.h"

#include <thread>

namespace ddt::gl {

Thread::Thread() {
    std::thread([this] { run(); }).detach();
}

void Thread::push(std::function<void()> f) {
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_queue.push_back(std::move(f));
    }
    m_wake.notify_one();
}

void Thread::run() {
    for (;;) {
        std::function<void()> f;
        {
            std::unique_lock<std::mutex> lock(m_mutex);
            m_wake.wait(lock, [this] { return !m_queue.empty(); });
            f = std::move(m_queue.front());
            m_queue.pop_front();
        }
        f();
    }
}

} // namespace ddt::gl
