// SPDX-License-Identifier: Apache-2.0
// The ways in which a job can be done, all of which must give the same bits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/differential/random_job.h"

namespace ddt::test {

/// One way of doing a job.
struct Way {
    std::string name;
    int64_t target = 0; ///< Highway's; 0: the best
    int threads = 1;
    Device device = Device::cpu;
    bool part = false;        ///< RandomJob::part instead of the whole
    bool places = false;      ///< results go straight into the sink's memory
    bool halfs = false;       ///< the sink takes 16-bit floats
    bool other_reads = false; ///< loads in place of gathers, or gathers in place of loads
};

/// What came of it. Pixels that the mapping shows nothing at keep `mark`.
struct Done {
    static constexpr float mark = -12345.0f;
    Outcome outcome = Outcome::done;
    std::string error;
    std::vector<float> values; ///< of the whole or the part, row by row
};

/// One thread of the narrowest instruction set that this machine has.
Way reference_way();

/// Every other: the wider instruction sets, reads of the other kind, several threads, parts,
/// memory, and each of the devices, whole and in part.
std::vector<Way> other_ways(const std::vector<Device>& devices);

Done run(const RandomJob& job, const Way& way);

/// How many floats of a way's result are not those of the reference's, bit for bit; of halfs, not
/// the nearest halfs to those.
size_t differing(const RandomJob& job, const Done& reference, const Way& way, const Done& done);

/// What a result must never do, whatever the job: null where it keeps to that. What is finite stays
/// finite; without corrections everything that is blended stays within the range of the source, and
/// with them alpha within 0 to 1, or that range where it goes further.
const char* broken_promise(const RandomJob& job, const std::vector<float>& values);

} // namespace ddt::test
