// SPDX-License-Identifier: Apache-2.0
// Tells which stage of the work a thread's time goes to.
#pragma once

#include <chrono>
#include <cstdint>

namespace ddt {

/// Reads the clock at the stages' borders, a few times a tile or strip of output.
class StageClock {
public:
    void start() { m_last = now(); }
    /// Add the time since start() or the last lap to a stage.
    void lap(int64_t& stage) {
        const int64_t time = now();
        stage += time - m_last;
        m_last = time;
    }

private:
    static int64_t now() {
        using namespace std::chrono;
        return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
    }
    int64_t m_last = 0;
};

} // namespace ddt
