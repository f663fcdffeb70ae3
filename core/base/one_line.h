// SPDX-License-Identifier: Apache-2.0
// Messages are lines, whatever other libraries and users put into them.
#pragma once

#include <string>

namespace ddt {

/// The longest line: beside a path of the longest there is no room for another echo.
constexpr size_t longest_line = 4000;

/// `text` with a blank in place of its line breaks and the blanks round them, and none at the ends;
/// a line that repeats the one before is left out (OpenImageIO 3.1 says some things twice); of what
/// is too long for a line, the two ends.
inline std::string one_line(const std::string& text) {
    constexpr const char* blanks = " \t\r\n\v\f";
    std::string line, before;
    for (size_t at = text.find_first_not_of(blanks); at != std::string::npos;) {
        size_t end = text.find_first_of("\r\n\v\f", at);
        const size_t next = text.find_first_not_of(blanks, end);
        end = text.find_last_not_of(blanks, end == std::string::npos ? end : end - 1) + 1;
        const std::string part = text.substr(at, end - at);
        if (part != before)
            line += (line.empty() ? "" : " ") + part;
        before = part;
        at = next;
    }
    if (line.size() <= longest_line)
        return line;
    // Not within a character of UTF-8.
    const auto within = [&](size_t at) {
        return (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80;
    };
    size_t head = longest_line / 2 - 5, tail = line.size() - longest_line / 2;
    while (head > 0 && within(head))
        --head;
    while (tail < line.size() && within(tail))
        ++tail;
    return line.substr(0, head) + " ... " + line.substr(tail);
}

} // namespace ddt
