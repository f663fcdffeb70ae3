// SPDX-License-Identifier: Apache-2.0
// Time that the device spends on each stage of the work.
#pragma once

#include <vector>

#include "core/gl/context/functions.h"

namespace ddt::gl {

enum class Stage { upload, triangulate, surface, sample, download, count };

/// Collects time stamps; reading them waits for the device. To be used on the context's thread.
class StageTimer {
public:
    /// Off: measures nothing and costs nothing.
    StageTimer(const Functions& gl, bool on) : m_gl(gl), m_on(on) {}
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

    void begin(Stage stage);
    void end();
    /// Milliseconds of a stage, of all its begin()-end() pairs together.
    double milliseconds(Stage stage);
    bool on() const { return m_on; }

private:
    struct Span {
        Stage stage;
        GLuint queries[2];
        bool ended = false;
    };
    void collect();

    const Functions& m_gl;
    bool m_on;
    std::vector<Span> m_spans;
    double m_milliseconds[int(Stage::count)] = {};
};

} // namespace ddt::gl
