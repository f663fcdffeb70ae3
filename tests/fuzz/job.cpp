// SPDX-License-Identifier: Apache-2.0
// Small jobs of the core: any options, any floats. Three threads, a part, and results in place give
// the bits of one thread; the promises about ranges and NaN hold.
#include "ddt/option_table.h"
#include "tests/differential/ways.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

using namespace ddt;
using namespace ddt::test;
using namespace ddt::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    Bytes bytes(data, size);
    RandomJob drawn;
    drawn.width = bytes.between(1, 24);
    drawn.height = bytes.between(1, 24);
    const int channels = bytes.between(1, 6);
    for (int c = 0; c < channels; ++c)
        drawn.job.kinds.push_back(Channel(bytes.below(3)));
    drawn.specification = bytes.line(120);
    const int out_width = drawn.width + bytes.below(50),
              out_height = drawn.height + bytes.below(50);
    set_shape(drawn, channels, out_width, out_height, 0.1 * bytes.below(4));
    FilterOptions options;
    std::string error;
    if (!parse_filter(drawn.specification, options, error)) {
        require_error_line(error);
        return 0;
    }
    // Time, not reach.
    options.mesh.max_iterations = std::min(options.mesh.max_iterations, 20);
    drawn.job.mesh = options.mesh;
    drawn.job.surface = options.surface;
    const size_t pixels = size_t(drawn.width) * size_t(drawn.height);
    // Half the pictures are shades, which have edges to flip; the others any floats at all.
    const bool shades = bytes.coin();
    const auto number = [&] {
        return shades ? float(bytes.take<uint8_t>()) / 255 : bytes.take<float>();
    };
    for (size_t i = 0; i < pixels; ++i) {
        drawn.guide.push_back(number());
        for (int c = 0; c < channels; ++c)
            drawn.values.push_back(c == 0 && shades ? drawn.guide.back() : number());
    }

    const Done one = run(drawn, {"one thread"});
    require(one.outcome == Outcome::done, one.error);
    if (const char* broken = broken_promise(drawn, one.values))
        require(false, broken);
    for (const Way& way : {Way{"three threads, in place", 0, 3, Device::cpu, false, true},
                           Way{"a part", 0, 1, Device::cpu, true}}) {
        const Done done = run(drawn, way);
        require(done.outcome == Outcome::done, done.error);
        require(differing(drawn, one, way, done) == 0, way.name + " gives the same bits");
    }
    return 0;
}
