// SPDX-License-Identifier: Apache-2.0
// Specifications of filters.
#include <algorithm>
#include <charconv>
#include <limits>
#include <locale>
#include <sstream>
#include <utility>

#include "core/base/float_mode.h"
#include "core/base/one_line.h"
#include "core/base/parse_number.h"
#include "core/options/values.h"
#include "ddt/names.h"
#include "ddt/option_table.h"

namespace ddt {

namespace {

/// In quotes, and in one line whatever it holds.
std::string quoted(std::string_view text) {
    return '"' + without_control_characters(text) + '"';
}

/// Of a number that no float holds: whether it is too small, not too large. std::from_chars says
/// the same of both.
bool underflows(std::string_view text) {
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    float number = 0;
    return bool(stream >> number);
}

/// Says why `item`, "key=value", cannot be.
std::string refusal(const Option& option, std::string_view item) {
    const DefaultFloats always;
    std::string line = "ddt: option " + quoted(item) + " is not allowed; allowed for " +
                       option.key + " are " + option.allowed();
    const std::string_view value = item.substr(item.find('=') + 1);
    float number = 0;
    const auto parsed = std::from_chars(value.data(), value.data() + value.size(), number);
    if (option.kind == OptionKind::real &&
        (value == "subnormal" || is_subnormal(number) ||
         (parsed.ec == std::errc::result_out_of_range && underflows(value))))
        line += ", none but 0 below " + number_text(std::numeric_limits<float>::min());
    return line;
}

std::string unknown(std::string_view key) {
    std::vector<std::string> keys;
    for (const Option& option : option_table())
        keys.emplace_back(option.key);
    return "ddt: unknown option " + quoted(key) + "; allowed are " + joined(keys);
}

/// The row that was set, or null with the reason in `error`.
const Option* set(std::string_view item, FilterOptions& options, std::string& error) {
    const size_t equals = item.find('=');
    const Option* option = find_option(item.substr(0, equals));
    if (!option)
        error = unknown(item.substr(0, equals));
    else if (equals == item.npos || !option->set(options, item.substr(equals + 1)))
        error = refusal(*option, item);
    else
        return option;
    return nullptr;
}

/// What the option is where it is not given; null for the field's own default.
const char* preset_of(const Option& option, std::string_view filter, const FilterOptions& options) {
    if (option.holds && !option.holds(options))
        return option.otherwise;
    for (const Option::Preset& preset : option.presets)
        if (filter == preset.filter)
            return preset.value;
    return nullptr;
}

} // namespace

bool parse_filter(std::string_view spec, FilterOptions& options, std::string& error) {
    const std::string_view name = spec.substr(0, spec.find(','));
    const FilterRow* filter = find_filter(name);
    if (!filter) {
        error = "ddt: unknown filter " + quoted(name) + "; allowed are " + joined(filter_names());
        return false;
    }
    FilterOptions parsed;
    parsed.surface.kind = filter->kind;
    std::vector<const Option*> given;
    for (size_t begin = name.size(), end; begin < spec.size(); begin = end) {
        end = std::min(spec.find(',', begin + 1), spec.size());
        const Option* option = set(spec.substr(begin + 1, end - begin - 1), parsed, error);
        if (!option)
            return false;
        given.push_back(option);
    }
    for (const Option& option : option_table())
        if (std::find(given.begin(), given.end(), &option) == given.end())
            if (const char* preset = preset_of(option, name, parsed))
                option.set(parsed, preset);
    options = std::move(parsed);
    return true;
}

bool set_option(std::string_view item, FilterOptions& options, std::string& error) {
    return set(item, options, error) != nullptr;
}

std::string default_text(const Option& option, std::string_view filter) {
    FilterOptions options;
    std::string error;
    parse_filter(filter, options, error);
    return option.get(options);
}

bool check_options(const FilterOptions& options, std::string& error) {
    const DefaultFloats always; // a NaN shall not trap
    if (options.surface.kind > Surface::patch) {
        error = "ddt: SurfaceOptions::kind must be linear or patch";
        return false;
    }
    FilterOptions scratch;
    for (const Option& option : option_table()) {
        const std::string value = option.get(options);
        if (!option.set(scratch, value)) {
            error = refusal(option, std::string(option.key) + "=" + value);
            return false;
        }
    }
    return true;
}

bool check_options(const MeshOptions& mesh, std::string& error) {
    FilterOptions options;
    options.mesh = mesh;
    return check_options(options, error);
}

} // namespace ddt
