// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/progress.h"

#include <algorithm>
#include <cstdio>

#include <unistd.h>

namespace ddt::tool {

namespace {

int percent(float share) {
    return int(std::clamp(share, 0.0f, 1.0f) * 100.0f);
}

} // namespace

Progress::Progress(std::string label, const bool* terminal)
    : m_label(std::move(label)), m_terminal(terminal ? *terminal : isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (m_shown >= 0)
        std::fputs("\r\033[K", stderr);
}

bool Progress::operator()(float share) {
    // A rough share may fall; the bar does not.
    const int now = percent(share);
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
