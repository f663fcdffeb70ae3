// SPDX-License-Identifier: Apache-2.0
// Messages are lines, whatever other libraries and users put into them.
#pragma once

#include <string>
#include <string_view>

namespace ddt {

/// The longest line: beside a path of the longest there is no room for another echo.
constexpr size_t longest_line = 4000;

/// `text` with a question mark in place of each control character, with which a file or its name
/// could tell a terminal what to do; a tab may stay.
std::string without_control_characters(std::string_view text);

/// `text` with a blank in place of its line breaks and the blanks round them, and none at the ends;
/// a line that repeats the one before is left out (OpenImageIO 3.1 says some things twice); of what
/// is too long for a line, the two ends; and without_control_characters().
std::string one_line(const std::string& text);

/// What every message begins with, and a message with it, once, and without it.
constexpr char message_prefix[] = "ddt: ";
std::string with_prefix(const std::string& message);
std::string without_prefix(const std::string& message);

/// What is said where memory ran out.
constexpr char out_of_memory_text[] = "out of memory";

/// What is said of a device that was named, between its name and why it cannot be had.
constexpr char unavailable_text[] = " is unavailable: ";

} // namespace ddt
