// SPDX-License-Identifier: Apache-2.0
// What a host has set for floating point neither changes a bit nor is changed.
#include <cfenv>
#include <cmath>

#include "core/base/arith.h"
#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

/// Noise from the smallest floats to large ones, enlarged; row by row or position by position.
std::vector<float> result(const SurfaceOptions& surface, bool one_by_one) {
    const Rect window{0, 0, 40, 30}, out{0, 0, 120, 90};
    TestSource source(window, 1, 3);
    Random random(11);
    for (float& v : source.values())
        v = std::ldexp(random.unit() - 0.5f, int(200 * random.unit()) - 149);
    Job job = job_of(source, 1);
    job.surface = surface;
    const ResizeMapping rows = mapping_of(window, out, out);
    const Opaque positions(rows);
    TestSink sink(out, 1);
    std::string error;
    EXPECT_EQ(enlarge(source, sink, one_by_one ? static_cast<const Mapping&>(positions) : rows, job,
                      &error),
              Outcome::done)
        << error;
    return sink.values();
}

class HostsMode : public testing::Test {
protected:
    void TearDown() override { std::fesetround(FE_TONEAREST); }
};

TEST_F(HostsMode, NeitherMattersNorChanges) {
    for (const bool one_by_one : {false, true})
        for (const SurfaceOptions& surface : surfaces_with({0, 1})) {
            const std::vector<float> usual = result(surface, one_by_one);
            std::fesetround(FE_UPWARD);
            const std::vector<float> upward = result(surface, one_by_one);
            EXPECT_EQ(std::fegetround(), FE_UPWARD);
            std::fesetround(FE_TONEAREST);
            EXPECT_EQ(hash(usual), hash(upward));
            const DenormalsAreZero as_some_hosts;
            EXPECT_EQ(hash(usual), hash(result(surface, one_by_one)));
        }
}

} // namespace
} // namespace ddt::test
