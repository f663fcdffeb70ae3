// SPDX-License-Identifier: Apache-2.0
// Enlarging a picture twofold on a device, stage by stage, with the device's own clock.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/gl/gpu.h"
#include "core/gl/stage_timer.h"
#include "core/gl/surfaces.h"
#include "tests/bench/gpu/picture.h"
#include "tests/bench/gpu/traffic.h"

namespace ddt::bench {

struct Measured {
    double milliseconds[int(gl::Stage::count)] = {}; ///< of the fastest run, by kernels
    std::map<std::string, int> dispatches;           ///< by kernel
    std::map<std::string, double> kernels; ///< where asked for: milliseconds, of a run of their own
    int batches = 0;
    size_t uploaded = 0, downloaded = 0; ///< bytes
    Workload work;
    std::vector<uint32_t> result; ///< where asked for: the bits of the output
};

/// Works on the context's thread. Of the job the window, the channels, mesh and surface count.
/// `keep_result`: for comparison. `by_kernel`: with
/// Measured::kernels.
Measured measure(gl::Gpu& gpu, Picture& picture, const Job& job, int runs, bool keep_result,
                 bool by_kernel);

/// Bytes a second that the device copies, counting those read and those written.
double copy_bandwidth(gl::Gpu& gpu);

} // namespace ddt::bench
