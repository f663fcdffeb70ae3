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

/// For the small functions of the -inl.h files: a call would pass vectors through memory.
#define DDT_INLINE inline __attribute__((always_inline))
/// The same of a lambda, after its parameters.
#define DDT_INLINED __attribute__((always_inline))

namespace ddt {

/// What every NaN of a result becomes: their bits would be up to each compiler.
constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

namespace scalar {

/// First guess of 1/sqrt(x), x > 0, about 3 % off: integer arithmetic on the float's bits.
inline float rsqrt_seed(float x) {
    return float_of(uint32_t(rsqrt_magic - (int32_t(bits_of(x)) >> 1)));
}

#include "core/base/rsqrt-inl.h"

} // namespace scalar
} // namespace ddt
