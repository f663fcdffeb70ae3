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

/// Bytes of the character that begins at text[at]; 1 of what is no UTF-8, such as a longer form
/// than need be, which a terminal may take for the shorter one's.
size_t character_length(std::string_view text, size_t at) {
    const auto byte = [&](size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned first = byte(at), second = byte(at + 1);
    const size_t length = first < 0xC2 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (first > 0xF4 || (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90))
        return 1;
    for (size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xC0) != 0x80)
            return 1;
    return length;
}

/// Of ASCII, and of the 32 from U+0080 on: C2 80 to C2 9F in UTF-8, single bytes to a terminal that
/// reads Latin-1.
bool is_control(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    if (character.size() == 2)
        return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
    return character.size() == 1 && (first < 0x20 || (first >= 0x7F && first < 0xA0));
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

std::string without_control_characters(std::string_view text) {
    std::string line;
    for (size_t at = 0, length; at < text.size(); at += length) {
        length = character_length(text, at);
        const std::string_view character = text.substr(at, length);
        if (is_control(character) && character != "\t")
            line += '?';
        else
            line += character;
    }
    return line;
}

std::string one_line(const std::string& text) {
    const std::string line = without_control_characters(joined(text));
    return line.size() <= longest_line ? line : two_ends(line);
}

std::string with_prefix(const std::string& message) {
    return has_prefix(message) ? message : message_prefix + message;
}

std::string without_prefix(const std::string& message) {
    return has_prefix(message) ? message.substr(prefix_length) : message;
}

} // namespace ddt
