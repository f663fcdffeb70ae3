// SPDX-License-Identifier: Apache-2.0
// Arithmetic that gives the same bits on every device.
//
// Rule: only float32 +, -, * and comparisons, in one written order, never contracted to a fused
// multiply-add (-ffp-contract=off here, `precise` in the shaders); no division, no square root.
// IEEE 754 rounds these correctly, and GLSL 4.60 section 4.7.1 demands it of +, -, * too.
//
// The few quotients that there are (1/tau of soft edges, shares of meshes, temperatures) and the
// unit of a mesh of points are made on the CPU, correctly rounded, and handed over to devices,
// which never divide. Interpolating over points and in holes is the CPU's alone: it uses doubles
// and divisions.
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/constants.h"
#include "core/base/float_bits.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

/// For the small functions of the -inl.h files: a call would pass vectors through memory.
#define DDT_INLINE inline __attribute__((always_inline))
/// The same of a lambda, after its parameters.
#define DDT_INLINED __attribute__((always_inline))

namespace ddt {

/// What every NaN of a result becomes: their bits would be up to each compiler.
constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

/// While it lives, this thread treats denormal floats as zero, as GPUs do, rounds to nearest and
/// traps nothing, whatever its caller has set. Otherwise values below 1.2e-38 could differ between
/// devices. On processors other than x86-64 and AArch64 it does nothing: there, bits are promised
/// only where no operation meets or makes such a value. What is a little less than 2^-126 and would
/// be rounded to it is that on x86-64, and zero on AArch64, which looks before it rounds.
class DenormalsAreZero {
public:
#if defined(__SSE2__)
    DenormalsAreZero() : m_saved(_mm_getcsr()) {
        _mm_setcsr(0x9fc0u);
    }
    ~DenormalsAreZero() {
        _mm_setcsr(m_saved);
    }
#elif defined(__aarch64__)
    DenormalsAreZero() {
        asm volatile("mrs %0, fpcr" : "=r"(m_saved));
        asm volatile("msr fpcr, %0" ::"r"(uint64_t(1) << 24));
    }
    ~DenormalsAreZero() {
        asm volatile("msr fpcr, %0" ::"r"(m_saved));
    }
#else
    // Not defaulted: an object that is only there to live must not look unused.
    DenormalsAreZero() {}
#endif
    DenormalsAreZero(const DenormalsAreZero&) = delete;
    DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

private:
#if defined(__SSE2__)
    unsigned m_saved;
#elif defined(__aarch64__)
    uint64_t m_saved;
#endif
};

namespace scalar {

/// First guess of 1/sqrt(x), x > 0, about 3 % off: integer arithmetic on the float's bits.
inline float rsqrt_seed(float x) {
    return float_of(uint32_t(rsqrt_magic - (int32_t(bits_of(x)) >> 1)));
}

#include "core/base/rsqrt-inl.h"

} // namespace scalar
} // namespace ddt
