// SPDX-License-Identifier: Apache-2.0
// An image whose holes were filled.
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "ddt/job.h"

namespace ddt {

/// All pixels of another source, in memory.
class WholeSource final : public Source {
public:
    /// Read the job's window of `source` on so many threads and fill what is missing, as Job::holes
    /// says; `progress` in place of the job's own, not called if nothing is missing. Not
    /// Outcome::done: with one line in `error`, or none if the source failed or it was cancelled.
    Outcome fill(Source& source, const Job& job, int threads, const ProgressCallback& progress,
                 std::string& error);
    bool read(const Rect& r, float* values, float* guide) override;

private:
    size_t place(int x, int y) const {
        return size_t(y - m_window.y0) * size_t(m_window.width()) + size_t(x - m_window.x0);
    }

    Rect m_window;
    size_t m_channels = 0;
    std::vector<float> m_values, m_guide;
};

} // namespace ddt
