// SPDX-License-Identifier: Apache-2.0
// How many threads a job has.
#pragma once

#include "core/base/parallel.h"
#include "ddt/job.h"

namespace ddt {

inline int thread_count(const Job& job) {
    return job.threads > 0 ? allowed_threads(job.threads) : usual_threads();
}

} // namespace ddt
