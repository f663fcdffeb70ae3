// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <hwy/highway.h>

namespace ddt::test {

/// Have what is compiled for several instruction sets use this one from now on, or, if 0, the best
/// that the machine has.
inline void use_simd(int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target ? target : hwy::SupportedTargets());
}

} // namespace ddt::test
