// SPDX-License-Identifier: Apache-2.0
#include "core/gl/stage_timer.h"

namespace ddt::gl {

StageTimer::~StageTimer() {
    for (const Span& span : m_spans)
        m_gl.DeleteQueries(2, span.queries);
}

void StageTimer::begin(Stage stage) {
    if (!m_on)
        return;
    m_spans.push_back({stage, {}, false});
    m_gl.GenQueries(2, m_spans.back().queries);
    m_gl.QueryCounter(m_spans.back().queries[0], GL_TIMESTAMP);
}

void StageTimer::end() {
    if (!m_on)
        return;
    m_gl.QueryCounter(m_spans.back().queries[1], GL_TIMESTAMP);
    m_spans.back().ended = true;
}

void StageTimer::collect() {
    for (const Span& span : m_spans) {
        if (span.ended) { // not where something was thrown
            GLuint64 from = 0, to = 0;
            m_gl.GetQueryObjectui64v(span.queries[0], GL_QUERY_RESULT, &from);
            m_gl.GetQueryObjectui64v(span.queries[1], GL_QUERY_RESULT, &to);
            m_milliseconds[int(span.stage)] += double(to - from) * 1e-6;
        }
        m_gl.DeleteQueries(2, span.queries);
    }
    m_spans.clear();
}

double StageTimer::milliseconds(Stage stage) {
    collect();
    return m_milliseconds[int(stage)];
}

} // namespace ddt::gl
