// SPDX-License-Identifier: Apache-2.0
// A function of one number, tabled finely enough for float pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/float_bits.h"

namespace ddt {

/// A continuous function tabled at every 1024th of an octave, for arguments of 2^-56 to 2^17 in
/// magnitude and of either sign, and linear between these points: for the power curves of colour
/// spaces that is within 2^-21 of the value, for a hundredth of pow's time.
class Curve {
public:
    /// Arguments at which fill() wants to know the function, in order.
    static std::vector<float> arguments();
    /// Take the function's values at arguments().
    void fill(const float* values);
    bool operator==(const Curve& other) const { return m_values == other.m_values; }

    /// True for the arguments that the table covers; operator() is defined for these alone.
    static bool covers(float x) { return (bits_of(x) & 0x7fffffffu) < last; }
    float operator()(float x) const {
        const uint32_t u = bits_of(x), size = u & 0x7fffffffu;
        const float* v = m_values.data() + (u >> 31) * half;
        if (size < first) { // a straight line through 0
            const float zero = v[0], end = v[1];
            return zero + (end - zero) * (float_of(size) * (1.0f / lowest));
        }
        v += 1 + ((size - first) >> shift);
        const float t = float(int32_t(size & ((1u << shift) - 1))) * (1.0f / (1u << shift));
        return v[0] + (v[1] - v[0]) * t;
    }

    /// Replace numbers by the curve at them, by the widest vectors this machine has; the bits are
    /// those of operator(). Stops early, at 0 or the last whole vector: returns how many were done.
    size_t apply(float* x, size_t n) const;

    /// What fill() took, for tables made from this one.
    const float* values() const { return m_values.data(); }

    static constexpr int shift = 13; // of 23 bits of mantissa: 1024 points an octave
    static constexpr float lowest = 0x1p-56f;
    static constexpr uint32_t first = uint32_t(127 - 56) << 23; // the bits of 2^-56
    static constexpr uint32_t last = uint32_t(127 + 17) << 23;  // the bits of 2^17
    // A half of the table: the value at 0, then those at 2^-56 to 2^17, both included.
    static constexpr size_t half = 1 + ((last - first) >> shift) + 1;

private:
    std::vector<float> m_values; // positive half, then negative half
};

} // namespace ddt
