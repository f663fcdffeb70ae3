// SPDX-License-Identifier: Apache-2.0
// Whole jobs from memory to memory, as a program would ask for them: what is copied counts.
#pragma once

#include <vector>

#include "ddt/job.h"
#include "tests/bench/gpu/picture.h"

namespace ddt::bench {

/// Milliseconds of enlarging the picture twofold, of each run; of the job, the device, the threads,
/// mesh and surface count. The result's memory is there before: `sink`'s. Throws where a job fails
/// or another device does it.
std::vector<double> time_jobs(Picture& picture, const Job& job, int runs, TwiceTheSize& sink);

} // namespace ddt::bench
