// SPDX-License-Identifier: Apache-2.0
// The software devices that tests run on.
#pragma once

#include <cstdlib>
#include <set>
#include <string>

#include "core/gl/context/faults.h"
#include "core/gl/gpu.h"
#include "tests/core/gl/enlarge_pair.h"

namespace ddt::test {

/// Tests of a software device; skipped, and it says why, where the library is not installed.
class OnDevice : public testing::TestWithParam<Device> {
protected:
    void SetUp() override {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        const Picture dot{2, 2, 1, {0, 1, 0, 0}, {0, 1, 0, 0}};
        Order order;
        order.out_width = order.out_height = 4;
        const Result result = enlarge_on(GetParam(), dot, order);
        if (result.outcome == Outcome::device_unavailable)
            GTEST_SKIP() << result.error << " (./check installs what it needs)";
    }

    /// The device, opened anew and checked as hardware is.
    gl::Gpu& fresh_device() const {
        gl::forget_devices();
        std::string why;
        bool forked = false;
        gl::Gpu* gpu = gl::open(GetParam(), why, forked);
        EXPECT_NE(gpu, nullptr) << why;
        gpu->checks.tested_too = true;
        return *gpu;
    }
};

/// The programs that are there, by name.
inline std::set<std::string> programs_of(const gl::Gpu& gpu) {
    const auto names = gpu.programs->names();
    return {names.begin(), names.end()};
}

inline std::string device_name(const testing::TestParamInfo<Device>& info) {
    return info.param == Device::egl ? "egl" : "osmesa";
}

} // namespace ddt::test
