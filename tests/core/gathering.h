// SPDX-License-Identifier: Apache-2.0
// How many threads are somewhere at once, counted by letting none go on before.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace ddt::test {

/// Waits for so many threads to be there at once, or for a minute.
class Gathering {
public:
    explicit Gathering(int wanted) : m_wanted(wanted) {}
    /// The most there were at once.
    int most() const { return m_most; }

    /// A thread is there while its Guest lives.
    class Guest {
    public:
        explicit Guest(Gathering& at) : m_at(at) {
            std::unique_lock<std::mutex> lock(at.m_mutex);
            at.m_most = std::max(at.m_most, ++at.m_there);
            at.m_changed.notify_all();
            at.m_changed.wait_for(lock, std::chrono::minutes(1),
                                  [&] { return at.m_most >= at.m_wanted; });
        }
        ~Guest() {
            const std::lock_guard<std::mutex> lock(m_at.m_mutex);
            --m_at.m_there;
        }
        Guest(const Guest&) = delete;
        Guest& operator=(const Guest&) = delete;

    private:
        Gathering& m_at;
    };

private:
    const int m_wanted;
    int m_there = 0, m_most = 0;
    std::mutex m_mutex;
    std::condition_variable m_changed;
};

} // namespace ddt::test
