// SPDX-License-Identifier: Apache-2.0
// Floats and their bits.
#pragma once

#include <cstdint>
#include <cstring>

namespace ddt {

inline uint32_t bits_of(float v) {
    uint32_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    return bits;
}

inline float float_of(uint32_t bits) {
    float v;
    std::memcpy(&v, &bits, sizeof v);
    return v;
}

/// `first ? a : b`, which compilers may make a branch of, and then no vectors of what is beside it.
inline uint32_t choose(bool first, uint32_t a, uint32_t b) {
    return b ^ ((a ^ b) & (0u - uint32_t(first)));
}

} // namespace ddt
