// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/thread.h"

#include "core/base/float_mode.h"

namespace ddt::gl {

Thread::Thread() {
    std::thread thread([this] { run(); });
    m_id = thread.get_id();
    thread.detach();
}

void Thread::push(Task& task) noexcept {
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        *m_end = &task;
        m_end = &task.next;
    }
    m_wake.notify_one();
}

void Thread::run() {
    // A software renderer's threads inherit it if they are started from here: not where the host
    // has begun to use it before. Shaders need it of none.
    const DenormalsAreZero as_on_gpus;
    for (;;) {
        Task* task = nullptr;
        {
            std::unique_lock<std::mutex> lock(m_mutex);
            m_wake.wait(lock, [this] { return m_first != nullptr; });
            task = m_first;
            m_first = task->next;
            if (!m_first)
                m_end = &m_first;
        }
        task->run();
    }
}

} // namespace ddt::gl
