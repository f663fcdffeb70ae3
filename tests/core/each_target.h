// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/base/vectors/gathers.h"
#include "tests/use_simd.h"

namespace ddt::test {

/// Call f for every instruction set that was compiled and this machine has, and for what is there
/// for machines with none of them, with gathers and without.
template <class F>
void on_each_target(F&& f) {
    const bool quick = gathers_are_quick();
    auto targets = hwy::SupportedAndGeneratedTargets();
    if (std::find(targets.begin(), targets.end(), HWY_STATIC_TARGET) == targets.end())
        targets.push_back(HWY_STATIC_TARGET);
    for (const int64_t target : targets) {
        use_simd(target);
        SCOPED_TRACE(hwy::TargetName(target));
        for (const bool gathers : {quick, !quick}) {
            SCOPED_TRACE(gathers ? "gathers" : "loads");
            set_gathers_are_quick(gathers);
            f();
        }
    }
    set_gathers_are_quick(quick);
    use_simd(0);
}

} // namespace ddt::test
