// SPDX-License-Identifier: Apache-2.0
// What must hold whatever the input.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace ddt::fuzz {

/// Ends the program, as a crash would, unless `holds`.
inline void require(bool holds, const std::string& what) {
    if (holds)
        return;
    std::fprintf(stderr, "broken: %s\n", what.c_str());
    std::abort();
}

/// An error is one line that names who speaks.
inline void require_error_line(const std::string& error) {
    require(error.compare(0, 5, "ddt: ") == 0, "an error begins with \"ddt: \": " + error);
    require(error.find('\n') == std::string::npos, "an error is one line: " + error);
    require(error.size() < 4096, "an error is short");
}

} // namespace ddt::fuzz
