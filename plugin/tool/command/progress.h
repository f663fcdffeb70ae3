// SPDX-License-Identifier: Apache-2.0
// Progress, as a bar for people or as lines for programs.
#pragma once

#include <chrono>
#include <string>

namespace ddt::tool {

enum class ProgressMode {
    automatic, ///< a bar if stderr is a terminal, else nothing
    lines,     ///< "ddt progress 45% resizing" on stderr, a line for every 5 % at most
    none,
};

/// One of "auto", "lines" and "none".
ProgressMode progress_mode(const std::string& name);

/// The bar is there from a second after the beginning on, and gone when this is destroyed. Call it
/// with the share done, 0 to 1; it always returns true. One thread at a time.
class Progress {
public:
    /// A null `terminal` asks whether stderr is one.
    explicit Progress(const std::string& label, ProgressMode mode = ProgressMode::automatic,
                      const bool* terminal = nullptr);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    bool operator()(float share);

    /// Another name for what goes on.
    void label(const std::string& text);
    /// Take the bar away, for a message; it comes again.
    void hide();

    /// The line shown: label, bar of 40 characters, percentage.
    static std::string line(const std::string& label, float share);

private:
    using Clock = std::chrono::steady_clock;
    std::string m_label;
    const ProgressMode m_mode;
    const bool m_terminal;
    const Clock::time_point m_begin = Clock::now();
    int m_shown = -1; ///< percent
};

} // namespace ddt::tool
