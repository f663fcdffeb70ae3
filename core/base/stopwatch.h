// SPDX-License-Identifier: Apache-2.0
// Time that has passed.
#pragma once

#include <chrono>

namespace ddt {

/// Runs from when it is made.
class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - m_begin).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    const Clock::time_point m_begin = Clock::now();
};

} // namespace ddt
