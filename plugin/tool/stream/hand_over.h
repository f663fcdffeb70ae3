// SPDX-License-Identifier: Apache-2.0
// A place for one thing between two threads.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace ddt::tool {

/// put() waits until the place is empty, take() until it is full. After close() nothing more goes
/// in; what is there still comes out.
template <class Thing>
class HandOver {
public:
    /// False: it is closed, and the thing is lost.
    bool put(Thing thing) {
        std::unique_lock<std::mutex> lock(m_mutex);
        m_changed.wait(lock, [&] { return m_closed || !m_thing; });
        if (m_closed)
            return false;
        m_thing = std::move(thing);
        m_changed.notify_all();
        return true;
    }
    /// Nothing: it is closed and empty.
    std::optional<Thing> take() {
        std::unique_lock<std::mutex> lock(m_mutex);
        m_changed.wait(lock, [&] { return m_closed || m_thing; });
        std::optional<Thing> thing = std::move(m_thing);
        m_thing.reset();
        m_changed.notify_all();
        return thing;
    }
    void close() {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_closed = true;
        m_changed.notify_all();
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<Thing> m_thing;
    bool m_closed = false;
};

} // namespace ddt::tool
