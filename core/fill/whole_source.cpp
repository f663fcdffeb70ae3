// SPDX-License-Identifier: Apache-2.0
#include "core/fill/whole_source.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"
#include "core/fill/fill.h"
#include "core/tiles/job_state.h"

namespace ddt {

namespace {

constexpr int rows_in_a_band = 64;

/// Of the time that reading and filling take, about.
constexpr float filling_begins = 0.02f;

} // namespace

Outcome WholeSource::fill(Source& source, const Job& job, int threads,
                          const ProgressCallback& progress, std::string& error) {
    m_window = job.window;
    m_channels = size_t(job.channels);
    if (m_window.area() > size_t(std::numeric_limits<int>::max())) {
        error = "ddt: holes are filled in images of up to " +
                std::to_string(std::numeric_limits<int>::max()) + " pixels";
        return Outcome::bad_job;
    }
    m_values.resize(m_window.area() * m_channels);
    m_guide.resize(m_window.area());
    const int bands = (m_window.height() + rows_in_a_band - 1) / rows_in_a_band;
    Job reading = job;
    reading.progress = part_of(progress, 0, filling_begins);
    JobState state(reading, bands);
    for_each_index(threads, bands, [&](int, int band) {
        const int y0 = m_window.y0 + band * rows_in_a_band;
        const Rect r{m_window.x0, y0, m_window.x1, std::min(y0 + rows_in_a_band, m_window.y1)};
        const size_t first = place(r.x0, r.y0);
        if (!state.going())
            return;
        if (source.read(r, &m_values[first * m_channels], &m_guide[first]))
            state.tile_done(band);
        else
            state.end(Outcome::source_failed);
    });
    if (!state.going())
        return state.outcome();
    const HoledImage image{m_values.data(),
                           m_guide.data(),
                           m_guide.data(),
                           m_window.width(),
                           m_window.height(),
                           job.channels,
                           job.kinds.empty() ? nullptr : job.kinds.data(),
                           threads};
    bool cancelled = false;
    ProgressCallback telling;
    if (progress)
        telling = [&](float share) {
            return !(cancelled = !progress(filling_begins + (1 - filling_begins) * share));
        };
    if (fill_missing(image, job.holes, job.mesh, job.device, telling, nullptr, error))
        return Outcome::done;
    return cancelled ? Outcome::cancelled : Outcome::bad_job;
}

bool WholeSource::read(const Rect& r, float* values, float* guide) {
    const auto width = size_t(r.width());
    for (int y = r.y0; y < r.y1; ++y, values += width * m_channels, guide += width) {
        const size_t first = place(r.x0, y);
        std::copy_n(&m_values[first * m_channels], width * m_channels, values);
        std::copy_n(&m_guide[first], width, guide);
    }
    return true;
}

} // namespace ddt
