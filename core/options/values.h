// SPDX-License-Identifier: Apache-2.0
// The values of options that are chosen by name, with what help says of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ddt/option_table.h"

namespace ddt {

/// A filter's name and what it is beside the options that have rows in the table.
struct FilterRow {
    NamedValue value;
    Surface kind;
};

/// "ddt" is the first.
const std::vector<FilterRow>& filter_rows();
/// The filter of that name, or null.
const FilterRow* find_filter(std::string_view name);

std::vector<NamedValue> cost_values();
std::vector<NamedValue> scheme_values();
std::vector<NamedValue> start_values();
std::vector<NamedValue> device_values();
std::vector<NamedValue> holes_values();

/// What schemes are allowed beside scheme_values(), in words.
std::string other_schemes();

/// "a, b, c"
std::string joined(const std::vector<std::string>& names);

} // namespace ddt
