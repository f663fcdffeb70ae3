// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/gpu/kernel_clock.h"

namespace ddt::bench {

KernelClock::~KernelClock() {
    for (const auto& [kernel, query] : m_stamps)
        m_gl.DeleteQueries(1, &query);
}

void KernelClock::next(const std::string& kernel) {
    GLuint query = 0;
    m_gl.GenQueries(1, &query);
    m_gl.QueryCounter(query, GL_TIMESTAMP);
    m_stamps.emplace_back(kernel, query);
}

std::map<std::string, double> KernelClock::milliseconds() const {
    std::map<std::string, double> by_kernel;
    GLuint64 from = 0, to = 0;
    for (size_t i = 0; i < m_stamps.size(); ++i, from = to) {
        m_gl.GetQueryObjectui64v(m_stamps[i].second, GL_QUERY_RESULT, &to);
        if (i > 0 && !m_stamps[i - 1].first.empty())
            by_kernel[m_stamps[i - 1].first] += double(to - from) * 1e-6;
    }
    return by_kernel;
}

} // namespace ddt::bench
