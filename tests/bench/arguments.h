// SPDX-License-Identifier: Apache-2.0
// Arguments of the programs that measure, taken as a whole or refused.
#pragma once

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/parse_number.h"

namespace bench {

/// Set `number` to the whole of `text`. False, with a line on stderr that begins with `what`, if
/// that is no number or not one from `low` to `high`.
template <class Number>
bool parse_argument(const char* what, const std::string& text, Number low, Number high,
                    Number& number) {
    if (ddt::parse_number(text, low, high, number))
        return true;
    std::ostringstream allowed;
    allowed << low << " to " << high;
    std::fprintf(stderr, "%s \"%s\" is not allowed; allowed are %s\n", what, text.c_str(),
                 allowed.str().c_str());
    return false;
}

/// The same for a list with commas, which must not be empty.
template <class Number>
bool parse_arguments(const char* what, const std::string& list, Number low, Number high,
                     std::vector<Number>& numbers) {
    numbers.clear();
    for (size_t at = 0; at <= list.size();) {
        const size_t comma = std::min(list.find(',', at), list.size());
        if (!parse_argument(what, list.substr(at, comma - at), low, high, numbers.emplace_back()))
            return false;
        at = comma + 1;
    }
    return true;
}

} // namespace bench
