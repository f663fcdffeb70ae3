// SPDX-License-Identifier: Apache-2.0
// How many threads a job has, and what each works on.
#pragma once

#include "core/base/parallel.h"
#include "ddt/job.h"

namespace ddt {

inline int thread_count(const Job& job) {
    return threads_for(job.threads);
}

/// Each thread's share, by which a device is chosen.
inline size_t pixels_a_thread(size_t pixels, const Job& job) {
    return pixels / size_t(thread_count(job));
}

} // namespace ddt
