// SPDX-License-Identifier: Apache-2.0
// The software devices that tests run on.
#pragma once

#include <cstdlib>

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
};

inline std::string device_name(const testing::TestParamInfo<Device>& info) {
    return info.param == Device::egl ? "egl" : "osmesa";
}

} // namespace ddt::test
