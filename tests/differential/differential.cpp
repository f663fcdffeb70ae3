// SPDX-License-Identifier: Apache-2.0
// Random jobs, each done in every way there is, compared bit for bit:
//
//   differential [--jobs 100] [--seed 1] [--first 0] [--devices egl,osmesa]
//
// The reference is one thread of the narrowest instruction set. Against it: every other instruction
// set, 1, 2 and 7 threads, a part of the output against the whole's crop, results put into the
// sink's memory, and each device, whole and in part. Beside that every result keeps its promises:
// what is finite stays finite, and in the range that it may have.
//
// A line for each way that differs, with the number that repeats it (--first N --jobs 1); exit
// status 1 if there is one, 2 for a wrong command line. A device that cannot be had is named and
// left out.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <OpenImageIO/argparse.h>
#include <OpenImageIO/strutil.h>

#include "ddt/names.h"
#include "tests/differential/ways.h"

namespace {

using namespace ddt;
using namespace ddt::test;

void report(const RandomJob& job, int number, const std::string& way, const std::string& what) {
    std::printf("job %d: %s: %s\n  %s\n", number, way.c_str(), what.c_str(), describe(job).c_str());
    std::fflush(stdout);
}

/// In how many ways the job comes out otherwise, or breaks a promise. Adds to `bytes` what was
/// compared.
int compare(const RandomJob& job, int number, const std::vector<Way>& ways, double& bytes) {
    const Done reference = run(job, reference_way());
    if (reference.outcome != Outcome::done) {
        report(job, number, "reference", reference.error);
        return 1;
    }
    int failures = 0;
    if (const char* broken = broken_promise(job, reference.values)) {
        report(job, number, "reference", broken);
        ++failures;
    }
    for (const Way& way : ways) {
        const Done done = run(job, way);
        std::string what = done.error;
        if (done.outcome == Outcome::done) {
            const size_t n = differing(job, reference, way, done);
            bytes += double(done.values.size() * sizeof(float));
            if (n == 0)
                continue;
            what =
                std::to_string(n) + " of " + std::to_string(done.values.size()) + " numbers differ";
        }
        report(job, number, way.name, what);
        ++failures;
    }
    return failures;
}

/// Those of the devices named that this machine has. False if one of the names is no device's.
bool devices_there(const std::string& names, std::vector<Device>& devices) {
    for (const std::string& name : OIIO::Strutil::splits(names, ",")) {
        Way way{name};
        if (!find_device(name, way.device) || way.device == Device::automatic ||
            way.device == Device::cpu) {
            std::fprintf(stderr,
                         "differential: no device to compare with: \"%s\"; allowed are "
                         "egl and osmesa\n",
                         name.c_str());
            return false;
        }
        const Done done = run(random_job(1, 0), way);
        if (done.outcome == Outcome::device_unavailable)
            std::printf("left out: %s\n", done.error.c_str());
        else
            devices.push_back(way.device);
    }
    return true;
}

} // namespace

int main(int argc, const char** argv) {
    int jobs = 100, seed = 1, first = 0;
    std::string devices = "egl,osmesa";
    OIIO::ArgParse args;
    args.intro("Does random jobs in every way there is and compares the bits.")
        .usage("differential [options]");
    args.arg("--jobs %d:N", &jobs).help("how many (100)");
    args.arg("--seed %d:N", &seed).help("another seed, other jobs (1)");
    args.arg("--first %d:N", &first).help("the number of the first (0)");
    args.arg("--devices %s:NAMES", &devices).help("beside the CPU (egl,osmesa); \"\" for none");
    if (args.parse_args(argc, argv) < 0)
        return 2;
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    std::vector<Device> there;
    if (!devices_there(devices, there))
        return 2;
    const std::vector<Way> ways = other_ways(there);
    double bytes = 0;
    int failures = 0;
    for (int i = first; i < first + jobs; ++i)
        failures += compare(random_job(uint64_t(seed), uint64_t(i)), i, ways, bytes);
    std::printf("%d jobs, %.1f MB compared, %d failures\n", jobs, bytes * 1e-6, failures);
    return failures ? 1 : 0;
}
