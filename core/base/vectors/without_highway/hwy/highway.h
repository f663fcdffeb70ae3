// SPDX-License-Identifier: Apache-2.0
// Stands in for Highway where that is not installed or not wanted (DDT_HIGHWAY=OFF): one target,
// whose vectors are those of core/base/vectors/plain_vectors.h.
//
// In the include path instead of Highway, never beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#define HWY_NAMESPACE N_PLAIN
#define HWY_BEFORE_NAMESPACE() static_assert(true, "")
#define HWY_AFTER_NAMESPACE() static_assert(true, "")
#define HWY_ONCE 1
#define HWY_ATTR
#define HWY_INLINE inline __attribute__((always_inline))
#define HWY_NOINLINE __attribute__((noinline))
#define HWY_ALIGN alignas(16)
#define HWY_MAX_BYTES 16
#define HWY_EXPORT(function) static_assert(true, "")
#define HWY_DYNAMIC_DISPATCH(function) N_PLAIN::function
// Of targets the one that has plain_vectors.h with Highway too.
#define HWY_EMU128 1
#define HWY_STATIC_TARGET HWY_EMU128
#define HWY_TARGET HWY_EMU128

namespace hwy {

// For tests, which run on each target.
static inline int64_t SupportedTargets() {
    return HWY_STATIC_TARGET;
}
static inline std::vector<int64_t> SupportedAndGeneratedTargets() {
    return {HWY_STATIC_TARGET};
}
static inline void SetSupportedTargetsForTest(int64_t) {}
static inline const char* TargetName(int64_t) {
    return "without Highway";
}
namespace {
struct ChosenTarget {
    void Update(int64_t) {}
};
} // namespace
static inline ChosenTarget GetChosenTarget() {
    return {};
}

} // namespace hwy
