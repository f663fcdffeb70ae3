// SPDX-License-Identifier: Apache-2.0
// What came of a check is remembered. Software renderers are checked here as hardware is elsewhere.
#include <set>
#include <string>

#include "core/gl/context/failure.h"
#include "core/gl/context/faults.h"
#include "core/gl/gpu.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"

namespace ddt::test {
namespace {

class SelfChecks : public OnDevice {
protected:
    void TearDown() override {
        gl::arm(gl::Fault::allocation, 0);
        gl::arm(gl::Fault::shader, 0);
        gl::forget_devices();
    }
};

TEST_P(SelfChecks, AFailureIsRememberedUnlessTheNextJobMayHaveMoreMemory) {
    gl::Gpu& device = fresh_device();
    const auto check = [&] {
        return device.thread.post([&] { return device.checks.differs(device, plain_job()); });
    };
    gl::arm(gl::Fault::allocation, 1);
    EXPECT_THROW(check().get(), gl::OutOfMemory);
    gl::arm(gl::Fault::allocation, 0);
    gl::arm(gl::Fault::shader, 1);
    EXPECT_NE(check().get().find("glCompileShader"), std::string::npos);
    EXPECT_NE(check().get().find("glCompileShader"), std::string::npos);
    EXPECT_EQ(gl::chances(gl::Fault::shader), 1) << "compiled again";
    gl::arm(gl::Fault::shader, 0);
}

TEST_P(SelfChecks, SoftwareIsNotCheckedUnlessAskedTo) {
    gl::Gpu& device = fresh_device();
    if (!device.context->software)
        GTEST_SKIP() << device.context->renderer << " is hardware";
    device.checks.tested_too = false;
    device.thread.post([&] { EXPECT_EQ(device.checks.differs(device, Job()), ""); }).get();
    EXPECT_EQ(programs_of(device), std::set<std::string>());
    EXPECT_EQ(device.checks.milliseconds(), 0.0);
}

// On one device: what is remembered is the same code on all.
INSTANTIATE_TEST_SUITE_P(Devices, SelfChecks, testing::Values(Device::egl), device_name);

} // namespace
} // namespace ddt::test
