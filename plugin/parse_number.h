// SPDX-License-Identifier: Apache-2.0
// Numbers in options.
#pragma once

#include <charconv>
#include <string>

namespace ddt {

/// Set `number` to what the whole of `text` says; false, and nothing is set, if that is no number
/// or not one from `low` to `high`.
template <class Number>
bool parse_number(const std::string& text, Number low, Number high, Number& number) {
    Number n{};
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, n);
    // Written so that NaN is not allowed.
    if (parsed.ec != std::errc() || parsed.ptr != end || !(n >= low && n <= high))
        return false;
    number = n;
    return true;
}

} // namespace ddt
