// SPDX-License-Identifier: Apache-2.0
// A device that is named and cannot be had.
#include "core/base/one_line.h"
#include "ddt/names.h"
#include "tests/core/gl/devices.h"
#include "tests/core/job_helpers.h"
#include "tests/environment.h"

namespace ddt::test {
namespace {

using Unavailable = OnDevice;

TEST_P(Unavailable, IsToldBeforeAnythingIsRead) {
    TestSource source({0, 0, 60, 50}, 1, 15);
    const Rect out{0, 0, 120, 100};
    const ResizeMapping mapping = mapping_of(source.window(), out, out);
    TestSink sink(out, 1);
    for (const bool by_environment : {false, true})
        for (const Holes holes : {Holes::keep, Holes::fill}) {
            const Environment named("DDT_DEVICE",
                                    by_environment ? ddt::device_name(GetParam()) : "cpu");
            Job job = job_of(source, 1);
            job.device = by_environment ? Device::automatic : GetParam();
            job.holes = holes;
            gl::forget_devices();
            gl::arm(gl::Fault::library, 1, 1000);
            std::string error;
            EXPECT_EQ(enlarge(source, sink, mapping, job, &error), Outcome::device_unavailable);
            EXPECT_NE(error.find(ddt::device_name(GetParam())), std::string::npos) << error;
            EXPECT_NE(error.find(unavailable_text), std::string::npos) << error;
            gl::arm(gl::Fault::library, 0);
            gl::forget_devices();
        }
    EXPECT_TRUE(source.reads.empty());
    EXPECT_EQ(sink.writes, 0);
}

INSTANTIATE_TEST_SUITE_P(Devices, Unavailable, testing::Values(Device::egl, Device::osmesa),
                         ddt::test::device_name);

} // namespace
} // namespace ddt::test
