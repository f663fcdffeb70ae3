// Enlarging a picture twofold on a device, stage by stage, with the device's own clock.
#pragma once

#include <vector>

#include "core/gl/gpu.h"
#include "core/gl/stages.h"
#include "core/gl/surfaces.h"
#include "tests/bench/gpu/picture.h"

namespace ddt::bench {

struct Measured {
    double milliseconds[int(gl::Stage::count)] = {}; ///< of the fastest run, by kernels
    int dispatches = 0;
    int batches = 0;
    std::vector<gl::IterationCounts> iterations; ///< sums over tiles; until none flips
    /// Bytes that triangulate, surface and sample cannot do without: each number once a pass.
    double bytes[3] = {};
    std::vector<uint32_t> result; ///< where asked for: the bits of the output, two halves a word
};

/// Works on the context's thread. `keep_result`: for comparison.
Measured measure(gl::Gpu& gpu, Picture& picture, const SurfaceOptions& surface, gl::Numbers numbers,
                 int runs, bool keep_result);

/// Bytes a second that the device copies, counting those read and those written.
double copy_bandwidth(gl::Gpu& gpu);

} // namespace ddt::bench
