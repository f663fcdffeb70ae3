// SPDX-License-Identifier: Apache-2.0
// A hash of bits, for tables of what results must be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ddt::test {

/// FNV-1a, 64 bits, of `size` bytes, going on from h. (RFC 9923.)
inline uint64_t fnv(const void* data, size_t size, uint64_t h = 0xcbf29ce484222325u) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (size_t i = 0; i < size; ++i)
        h = (h ^ bytes[i]) * 0x100000001b3u;
    return h;
}

/// Of the values' bits.
inline uint64_t fnv(const std::vector<float>& values) {
    return fnv(values.data(), values.size() * sizeof(float));
}

} // namespace ddt::test
