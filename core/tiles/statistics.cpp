// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "ddt/job.h"

namespace ddt {

Statistics& Statistics::operator+=(const Statistics& other) {
    pixels += other.pixels;
    evaluations += other.evaluations;
    flips += other.flips;
    rounds += other.rounds;
    iterations = std::max(iterations, other.iterations);
    times.read += other.times.read;
    times.triangulate += other.times.triangulate;
    times.surface += other.times.surface;
    times.sample += other.times.sample;
    times.write += other.times.write;
    return *this;
}

} // namespace ddt
