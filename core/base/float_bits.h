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

} // namespace ddt
