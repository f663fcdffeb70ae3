// SPDX-License-Identifier: Apache-2.0
// Numbers in texts.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "core/base/float_mode.h"

namespace ddt {

/// By its bits: to a thread that takes subnormal numbers for 0 they compare as 0.
template <class Real>
bool is_subnormal(Real n) {
    using Bits = std::conditional_t<sizeof(Real) == 4, uint32_t, uint64_t>;
    constexpr int mantissa = sizeof(Real) == 4 ? 23 : 52;
    static_assert(sizeof(Real) == sizeof(Bits));
    Bits bits;
    std::memcpy(&bits, &n, sizeof bits);
    return Bits(bits << 1) != 0 && Bits(bits << 1) >> (mantissa + 1) == 0;
}

/// Set `number` to what the whole of `text` says; false, and nothing is set, if that is no number,
/// or not one from `low` to `high`, or a subnormal one: those are 0 to some devices and not to
/// others.
template <class Number>
bool parse_number(std::string_view text, Number low, Number high, Number& number) {
    const DefaultFloats always;
    Number n{};
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, n);
    // Written so that NaN is not allowed.
    if (parsed.ec != std::errc() || parsed.ptr != end || !(n >= low && n <= high))
        return false;
    if constexpr (std::is_floating_point_v<Number>)
        if (is_subnormal(n))
            return false;
    number = n;
    return true;
}

/// Set width and height to what "WxH" says, each a whole number from `low` to `high`; false, and
/// nothing is set, if the text says something else.
inline bool parse_sides(std::string_view text, int low, int high, int& width, int& height) {
    const size_t x = text.find('x');
    int w = 0, h = 0;
    if (x == std::string_view::npos || !parse_number(text.substr(0, x), low, high, w) ||
        !parse_number(text.substr(x + 1), low, high, h))
        return false;
    width = w;
    height = h;
    return true;
}

} // namespace ddt
