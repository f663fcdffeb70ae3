// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/progress.h"

#include <algorithm>
#include <cstdio>

#include <unistd.h>

#include "core/base/one_line.h"

namespace ddt::tool {

namespace {

constexpr int line_every = 5; ///< percent

int percent(float share) {
    return int(std::clamp(share, 0.0f, 1.0f) * 100.0f);
}

} // namespace

ProgressMode progress_mode(const std::string& name) {
    return name == "lines"  ? ProgressMode::lines
           : name == "none" ? ProgressMode::none
                            : ProgressMode::automatic;
}

Progress::Progress(const std::string& label, ProgressMode mode, const bool* terminal)
    : m_label(one_line(label)), m_mode(mode),
      m_terminal(mode == ProgressMode::automatic &&
                 (terminal ? *terminal : isatty(STDERR_FILENO) == 1)) {}

Progress::~Progress() {
    hide();
}

void Progress::label(const std::string& text) {
    m_label = one_line(text);
}

void Progress::hide() {
    if (m_terminal && m_shown >= 0)
        std::fputs("\r\033[K", stderr);
}

bool Progress::operator()(float share) {
    // A rough share may fall; what is shown does not.
    const int now = percent(share);
    if (m_mode == ProgressMode::lines && now / line_every * line_every > m_shown) {
        m_shown = now / line_every * line_every;
        std::fprintf(stderr, "ddt progress %d%% %s\n", m_shown, m_label.c_str());
    }
    if (m_terminal && now > m_shown && Clock::now() - m_begin >= std::chrono::seconds(1)) {
        std::fprintf(stderr, "\r%s", line(m_label, share).c_str());
        std::fflush(stderr);
        m_shown = now;
    }
    return true;
}

std::string Progress::line(const std::string& label, float share) {
    constexpr int width = 40;
    const auto full = size_t(percent(share) * width / 100);
    std::string number = std::to_string(percent(share));
    return label + " [" + std::string(full, '=') + std::string(width - full, ' ') + "] " +
           std::string(3 - std::min<size_t>(3, number.size()), ' ') + number + " %";
}

} // namespace ddt::tool
