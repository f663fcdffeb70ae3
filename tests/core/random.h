// SPDX-License-Identifier: Apache-2.0
// Random numbers for tests.
#pragma once

#include <cstdint>

namespace ddt::test {

/// splitmix64: the same numbers everywhere, which the standard distributions do not promise.
class Random {
public:
    explicit Random(uint64_t seed) : m_state(seed) {}
    uint64_t bits() {
        uint64_t z = m_state += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    int below(int n) { return int(bits() % uint64_t(n)); }
    /// low <= result <= high
    int between(int low, int high) { return low + below(high - low + 1); }
    /// A multiple of 2^-24 in [0, 1).
    float unit() { return float(bits() >> 40) * (1.0f / 16777216.0f); }

private:
    uint64_t m_state;
};

} // namespace ddt::test
