// SPDX-License-Identifier: Apache-2.0
// The rows of the option table as parameters of hosts that show each option by itself.
#pragma once

#include <string>
#include <vector>

#include "ddt/option_table.h"

namespace ddt::host {

/// What a number that a filter presets is while the user has not touched it.
constexpr double filters_own = -1;
/// What it is for the name that it may have in place of a number: `auto` of `min_gain`.
constexpr double by_name = -2;

/// Decimals that a host is asked to show of reals: some show two unless told.
constexpr int shown_digits = 4;

/// An option as a parameter. `light` is not among them: what a host's numbers mean the host knows.
struct Parameter {
    const Option* option;
    /// The option's own, but choice for a toggle that a filter presets: "preset", "0" or "1".
    OptionKind kind;
    std::string label; ///< "Min gain"
    std::string help;
    /// real and whole: the range, from filters_own or by_name on where the filter presets the
    /// number; toggle: 0 and 1; choice: indices of `names`.
    double low, high;
    double shown_high; ///< what a slider should end at
    double initial;
    std::vector<std::string> names;

    bool is_main() const; ///< not one for experts
};

/// What the filters are, for the help of a list of them.
std::string help_of_filters();

/// In the order of the table.
std::vector<Parameter> make_parameters();

/// The same, made once; thread-safe.
const std::vector<Parameter>& parameters();

/// ",key=value" for a specification of the filter; empty for the initial value. Of numbers below 0
/// that stand for something the nearest counts, of one out of range the end that is nearest,
/// subnormal reals are 0, and NaN is the initial value.
std::string item(const Parameter& parameter, double value);

} // namespace ddt::host
