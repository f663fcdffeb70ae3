// SPDX-License-Identifier: Apache-2.0
// A progress bar.
#pragma once

#include <chrono>
#include <string>

namespace ddt::tool {

/// A bar on stderr if that is a terminal, from a second after its beginning on; gone when it is
/// destroyed. Call it with the share done, 0 to 1; it always returns true.
class Progress {
public:
    /// A null `terminal` asks whether stderr is one.
    explicit Progress(std::string label, const bool* terminal = nullptr);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    bool operator()(float share);

    /// The line shown: label, bar of 40 characters, percentage.
    static std::string line(const std::string& label, float share);

private:
    using Clock = std::chrono::steady_clock;
    const std::string m_label;
    const bool m_terminal;
    const Clock::time_point m_begin = Clock::now();
    int m_shown = -1; ///< percent
};

} // namespace ddt::tool
