// SPDX-License-Identifier: Apache-2.0
#include "core/base/one_line.h"

namespace ddt {

namespace {

constexpr const char* blanks = " \t\r\n\v\f";
constexpr const char* breaks = "\r\n\v\f";

std::string joined(const std::string& text) {
    std::string line, before;
    for (size_t at = text.find_first_not_of(blanks); at != std::string::npos;) {
        size_t end = text.find_first_of(breaks, at);
        const size_t next = text.find_first_not_of(blanks, end);
        end = text.find_last_not_of(blanks, end == std::string::npos ? end : end - 1) + 1;
        const std::string part = text.substr(at, end - at);
        if (part != before)
            line += (line.empty() ? "" : " ") + part;
        before = part;
        at = next;
    }
    return line;
}

/// Of ASCII, and of the 32 beyond it, which UTF-8 writes as C2 80 to C2 9F. A tab may stay.
void replace_control_characters(std::string& line) {
    for (size_t i = 0; i < line.size(); ++i) {
        const auto byte = static_cast<unsigned char>(line[i]);
        const auto next = static_cast<unsigned char>(i + 1 < line.size() ? line[i + 1] : '\0');
        if ((byte < 0x20 && byte != '\t') || byte == 0x7F)
            line[i] = '?';
        else if (byte == 0xC2 && next >= 0x80 && next < 0xA0)
            line.replace(i, 2, "?");
    }
}

/// The two ends of what is longer than longest_line, not cut within a character of UTF-8.
std::string two_ends(const std::string& line) {
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

constexpr size_t prefix_length = sizeof message_prefix - 1;

bool has_prefix(const std::string& message) {
    return message.compare(0, prefix_length, message_prefix) == 0;
}

} // namespace

std::string one_line(const std::string& text) {
    std::string line = joined(text);
    replace_control_characters(line);
    return line.size() <= longest_line ? line : two_ends(line);
}

std::string with_prefix(const std::string& message) {
    return has_prefix(message) ? message : message_prefix + message;
}

std::string without_prefix(const std::string& message) {
    return has_prefix(message) ? message.substr(prefix_length) : message;
}

} // namespace ddt
