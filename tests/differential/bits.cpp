// SPDX-License-Identifier: Apache-2.0
// A line for each of the first random jobs, with a hash of its result's bits, and one of guides:
// what builds of the core with other compilers and other libraries must agree on.
//
//   ddt_bits [JOBS]     (60)
//
// Exit status 1 if a job fails.
#include <cstdio>
#include <cstdlib>

#include "ddt/guide.h"
#include "tests/core/random.h"
#include "tests/differential/ways.h"
#include "tests/fnv.h"

using namespace ddt;
using namespace ddt::test;

namespace {

std::vector<float> guides() {
    Random random(7);
    std::vector<float> pixels(4 * 1001), guide(pixels.size() / 2);
    for (float& x : pixels)
        x = 4 * random.unit() - 1;
    for (const bool linear : {false, true})
        make_guide({{0, 1, 2}, {0.2126f, 0.7152f, 0.0722f}, 3, linear}, pixels.data(), 1001, 4,
                   guide.data() + (linear ? 1001 : 0));
    return guide;
}

} // namespace

int main(int argc, char** argv) {
    const int jobs = argc > 1 ? std::atoi(argv[1]) : 60;
    std::printf("guides %016llx\n", static_cast<unsigned long long>(fnv(guides())));
    for (int i = 0; i < jobs; ++i) {
        const RandomJob job = random_job(3, uint64_t(i));
        const Done done = run(job, Way{"2 threads", 0, 2});
        if (done.outcome != Outcome::done) {
            std::fprintf(stderr, "job %d: %s\n", i, done.error.c_str());
            return 1;
        }
        std::printf("job %d %016llx %s\n", i, static_cast<unsigned long long>(fnv(done.values)),
                    describe(job).c_str());
    }
    return 0;
}
