// SPDX-License-Identifier: Apache-2.0
// Numbers and texts taken from a fuzzer's input. When it is used up, zeros follow.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace ddt::fuzz {

class Bytes {
public:
    Bytes(const uint8_t* data, size_t size) : m_data(data), m_left(size) {}

    bool empty() const { return m_left == 0; }

    template <class T>
    T take() {
        T value{};
        const size_t n = std::min(m_left, sizeof value);
        if (n > 0)
            std::memcpy(&value, m_data, n);
        skip(n);
        return value;
    }

    /// 0 to n - 1, from as few bytes as are needed.
    int below(int n) { return int((n <= 256 ? take<uint8_t>() : take<uint32_t>()) % unsigned(n)); }
    /// low to high
    int between(int low, int high) { return low + below(high - low + 1); }
    bool coin() { return take<uint8_t>() & 1; }

    /// Up to `most` bytes, to the next line feed, which is passed over.
    std::string line(size_t most) {
        std::string text;
        while (m_left > 0 && text.size() < most) {
            const char c = char(take<uint8_t>());
            if (c == '\n')
                break;
            text += c;
        }
        return text;
    }

    std::string rest() {
        std::string text(m_data, m_data + m_left);
        skip(m_left);
        return text;
    }

private:
    void skip(size_t n) {
        m_data += n;
        m_left -= n;
    }

    const uint8_t* m_data;
    size_t m_left;
};

} // namespace ddt::fuzz
