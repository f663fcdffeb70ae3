// SPDX-License-Identifier: Apache-2.0
// The table of options: what a specification of a filter, such as "ddt-sharp,cost=scf", can say.
// A host that shows each option as a parameter of its own walks option_table().
//
// To add an option: a field in ddt/options.h, whose default is that of the filter `ddt`; a row in
// core/options/option_table.cpp, with the defaults of the other filters where they differ; its use.
// From the row come parsing, range checks of all entry points, error lines, the help of the tool
// and its man page, `ddt info`, the reader's query and the parameters of hosts; a test says which
// line README.md lacks.
//
// The functions are safe to call from several threads at once. They may throw std::bad_alloc; what
// they were to set is then as it was.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ddt/options.h"

namespace ddt {

/// What an option's values are.
enum class OptionKind : uint8_t {
    real,   ///< float32 numbers from Option::low to high, none subnormal
    whole,  ///< whole numbers from low to high
    toggle, ///< 0 or 1
    choice, ///< one of Option::values
    text,   ///< any text without comma, not empty; Option::values have a meaning of their own
};

/// What an option is about, for hosts that show options in groups.
enum class OptionGroup : uint8_t { colour, mesh, surface, device };

/// A name that an option can be set to.
struct NamedValue {
    const char* name;
    const char* help; ///< a sentence or two, with `code` in backquotes
};

/// A row of the table.
struct Option {
    const char* key;
    OptionGroup group;
    OptionKind kind;
    const char* help;               ///< as that of NamedValue
    double low, high;               ///< real and whole: the range; toggle: 0 and 1; else 0
    std::vector<NamedValue> values; ///< names; those of a number are allowed beside its range
    std::string others;             ///< what is allowed beside all that, in words, or empty

    /// The value as a text that set() takes for the same value. In C's notation whatever the
    /// locale.
    std::function<std::string(const FilterOptions&)> get;
    /// Set this option and no other; false, and nothing is set, if the value is not allowed.
    std::function<bool(FilterOptions&, std::string_view)> set;

    /// What a filter has instead of the field's own default.
    struct Preset {
        const char *filter, *value;
    };
    std::vector<Preset> presets;
    /// Where not null, defaults are meant for options of which this is true; for others the default
    /// is `otherwise`.
    bool (*holds)(const FilterOptions&) = nullptr;
    const char* otherwise = nullptr;

    /// What is allowed, in words: "whole numbers from 0 to 400".
    std::string allowed() const;
};

/// All options, in the order in which help lists them.
const std::vector<Option>& option_table();

/// The row of a key, or null.
const Option* find_option(std::string_view key);

/// The text of an option's default in the filter of that name, with the default cost and scheme.
std::string default_text(const Option& option, std::string_view filter);

/// A number as options spell it: the shortest text that parses to the same float;
/// "subnormal", which does not parse, for what no option may be.
std::string number_text(float number);

/// True if `spec` is one of filter_names() (ddt/names.h), or one followed by a comma and options.
bool is_filter_name(std::string_view spec);

/// What the surface of a filter is, in a sentence; empty if there is no filter of that name.
std::string filter_help(std::string_view name);

/// Parse "ddt,key=value,...". The result depends on `spec` alone: what it does not name has the
/// default of the filter. Five defaults depend on other options (Option::holds):
///     soft        0 unless the cost is abn
///     min_gain    the cost's own ("auto") unless the cost is abn and the scheme one-round
///     contour     0 unless the cost is abn and the scheme one-round
///     iterations  64 if the scheme is annealing
///     fitted      0 unless the filter is ddt-sharp, `clipped` 1, the cost abn and `consistency` 2
/// On failure false with a line in `error` (see ddt/core.h) that names the option and lists what is
/// allowed, and `options` unchanged.
bool parse_filter(std::string_view spec, FilterOptions& options, std::string& error);

/// Parse "key=value" and set this option and no other. On failure as parse_filter().
bool set_option(std::string_view item, FilterOptions& options, std::string& error);

/// True if every option has a value that its row allows; if not, `error` is the line that
/// parse_filter() has for it. Every entry point of the library checks its options so.
bool check_options(const FilterOptions& options, std::string& error);
bool check_options(const MeshOptions& options, std::string& error);

} // namespace ddt
