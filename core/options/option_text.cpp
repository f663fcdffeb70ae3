// SPDX-License-Identifier: Apache-2.0
// Options in words.
#include <charconv>
#include <cmath>

#include "core/base/parse_number.h"
#include "core/options/values.h"
#include "ddt/option_table.h"

namespace ddt {

std::string number_text(float number) {
    // The standard library takes them for 0 in threads that do.
    if (is_subnormal(number))
        return "subnormal";
    char text[32];
    // 1000000 and not 1e+06.
    const bool fixed = number == 0 || (std::fabs(number) >= 1e-4f && std::fabs(number) < 1e9f);
    const auto end = std::to_chars(text, text + sizeof text, number,
                                   fixed ? std::chars_format::fixed : std::chars_format::general);
    return {text, end.ptr};
}

std::string Option::allowed() const {
    std::vector<std::string> parts;
    const auto range = [&](const char* what) {
        const bool is_whole = kind == OptionKind::whole;
        const auto bound = [&](double v) {
            return is_whole ? std::to_string(int64_t(v)) : number_text(float(v));
        };
        parts.push_back(std::string(what) + " from " + bound(low) + " to " + bound(high));
    };
    if (kind == OptionKind::real)
        range("numbers");
    else if (kind == OptionKind::whole)
        range("whole numbers");
    else if (kind == OptionKind::toggle)
        parts = {"0", "1"};
    for (const NamedValue& value : values)
        parts.emplace_back(value.name);
    if (!others.empty())
        parts.push_back(others);
    return joined(parts);
}

} // namespace ddt
