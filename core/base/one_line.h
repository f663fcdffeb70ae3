// SPDX-License-Identifier: Apache-2.0
// Messages are lines, whatever other libraries and users put into them.
#pragma once

#include <string>

namespace ddt {

/// `text` with a blank in place of its line breaks and the blanks round them, and none at the ends.
inline std::string one_line(const std::string& text) {
    constexpr const char* blanks = " \t\r\n\v\f";
    std::string line;
    for (size_t at = text.find_first_not_of(blanks); at != std::string::npos;) {
        size_t end = text.find_first_of("\r\n\v\f", at);
        const size_t next = text.find_first_not_of(blanks, end);
        end = text.find_last_not_of(blanks, end == std::string::npos ? end : end - 1) + 1;
        line += (line.empty() ? "" : " ") + text.substr(at, end - at);
        at = next;
    }
    return line;
}

} // namespace ddt
