// SPDX-License-Identifier: Apache-2.0
// The two functions of Highway's library that dispatching by instruction set calls. With them a
// module for a foreign program needs no shared libhwy, which that program may not have or may have
// in another version. They name no more than is sure; the bits do not depend on it.
#include <hwy/targets.h>
#if HWY_ARCH_X86
#include <cpuid.h>

namespace {

// What clang before 15 has no name for.
bool has_f16c() {
    unsigned a, b, c, d;
    return __get_cpuid(1, &a, &b, &c, &d) && (c & bit_F16C) != 0;
}

} // namespace
#endif

namespace hwy {

int64_t SupportedTargets() {
    // One of these is always compiled.
    int64_t targets = HWY_EMU128 | HWY_SCALAR | HWY_STATIC_TARGET;
#if HWY_ARCH_X86
    __builtin_cpu_init();
    const bool ssse3 = __builtin_cpu_supports("ssse3");
    const bool sse4 = ssse3 && __builtin_cpu_supports("sse4.2") &&
                      __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
    const bool avx2 = sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && has_f16c();
    const bool avx3 = avx2 && __builtin_cpu_supports("avx512f") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
    targets |= (ssse3 ? HWY_SSSE3 : 0) | (sse4 ? HWY_SSE4 : 0) | (avx2 ? HWY_AVX2 : 0) |
               (avx3 ? HWY_AVX3 : 0);
#elif HWY_ARCH_ARM_A64
    targets |= HWY_NEON;
#endif
    return targets;
}

ChosenTarget& GetChosenTarget() {
    static ChosenTarget chosen;
    return chosen;
}

} // namespace hwy
