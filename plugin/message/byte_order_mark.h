// SPDX-License-Identifier: Apache-2.0
// What some editors and spreadsheets put in front of UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace ddt {

/// Where the text itself begins: after a byte-order mark, if there is one.
inline size_t begin_of_text(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.substr(0, mark.size()) == mark ? mark.size() : 0;
}

} // namespace ddt
