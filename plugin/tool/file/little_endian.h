// SPDX-License-Identifier: Apache-2.0
// Binary records of files whose numbers are in little endian order.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace ddt::tool {

/// A record's bytes, whatever the machine's order is.
class LittleEndian {
public:
    /// A whole number, in as many bytes as its type has.
    template <class Whole>
    void word(Whole v) {
        for (size_t k = 0; k < sizeof v; ++k)
            m_bytes += char(uint64_t(v) >> (8 * k) & 0xff);
    }
    void number(float v) { word(bits_of<uint32_t>(v)); }
    void number(double v) { word(bits_of<uint64_t>(v)); }
    /// Write them and begin the next record. Whether all could be written the file tells.
    void write(std::FILE* file) {
        std::fwrite(m_bytes.data(), 1, m_bytes.size(), file);
        m_bytes.clear();
    }

private:
    template <class Bits, class Number>
    static Bits bits_of(Number v) {
        Bits bits;
        static_assert(sizeof bits == sizeof v);
        std::memcpy(&bits, &v, sizeof bits);
        return bits;
    }

    std::string m_bytes;
};

} // namespace ddt::tool
