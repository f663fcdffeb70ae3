// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parse_number.h"
#include "ddt/names.h"

namespace ddt::host {
namespace {

/// "min_gain" as "Min gain".
std::string label_of(std::string key) {
    std::replace(key.begin(), key.end(), '_', ' ');
    key[0] = char(key[0] - 'a' + 'A');
    return key;
}

/// Without the backquotes of the table's texts.
std::string plain(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
    return text;
}

/// True if what the option is untouched depends on the filter or on other options.
bool is_preset(const Option& option) {
    return !option.presets.empty() || option.holds;
}

Parameter parameter(const Option& option) {
    return {&option, option.kind, label_of(option.key), plain(option.help), 0, 0, 0, 0, {}};
}

Parameter number(const Option& option, const std::string& initial) {
    Parameter p = parameter(option);
    // Hosts have signed numbers.
    p.high = std::min(option.high, double(std::numeric_limits<int>::max()));
    if (!is_preset(option)) {
        p.low = option.low;
        // Not std::stod(): the host's locale may have a comma.
        parse_number(initial, option.low, option.high, p.initial);
    } else {
        p.low = p.initial = filters_own;
        p.help += " -1: as the filter has it.";
        if (!option.values.empty()) {
            p.low = by_name;
            p.help += std::string(" -2: ") + option.values.front().name + ".";
        }
    }
    p.shown_high = std::min(p.high, 256.0);
    if (option.kind == OptionKind::real)
        p.shown_high = std::min(p.high, 2.0);
    return p;
}

Parameter choice(const Option& option, std::vector<std::string> names, const std::string& initial) {
    Parameter p = parameter(option);
    p.kind = OptionKind::choice;
    p.names = std::move(names);
    p.initial = double(std::find(p.names.begin(), p.names.end(), initial) - p.names.begin());
    p.high = p.shown_high = double(p.names.size()) - 1;
    return p;
}

std::vector<std::string> names_of(const Option& option) {
    std::vector<std::string> names;
    for (const NamedValue& value : option.values)
        names.emplace_back(value.name);
    return names;
}

Parameter toggle(const Option& option, const std::string& initial) {
    if (is_preset(option))
        return choice(option, {"preset", "0", "1"}, "preset");
    Parameter p = parameter(option);
    p.high = p.shown_high = 1;
    p.initial = initial == "1" ? 1 : 0;
    return p;
}

} // namespace

std::string help_of_filters() {
    std::string help;
    for (const std::string& filter : filter_names())
        help += (help.empty() ? "" : " ") + filter + ": " + plain(filter_help(filter));
    return help;
}

std::vector<Parameter> make_parameters() {
    std::vector<Parameter> all;
    const std::string filter = filter_names().front();
    for (const Option& option : option_table()) {
        const std::string initial = default_text(option, filter);
        switch (option.kind) {
        case OptionKind::real:
        case OptionKind::whole:
            all.push_back(number(option, initial));
            break;
        case OptionKind::toggle:
            all.push_back(toggle(option, initial));
            break;
        case OptionKind::choice:
            all.push_back(choice(option, names_of(option), initial));
            break;
        case OptionKind::text:
            break;
        }
    }
    return all;
}

bool Parameter::is_main() const {
    return option->group == OptionGroup::device;
}

const std::vector<Parameter>& parameters() {
    static const auto* all = new std::vector<Parameter>(make_parameters()); // never destroyed
    return *all;
}

namespace {

/// An expression or a curve may leave a range that a host keeps its sliders in, and one that eases
/// to 0 comes to subnormal floats, which no option may be.
double within_range(const Parameter& p, double value) {
    if (std::isnan(value))
        return p.initial;
    if (p.kind == OptionKind::real && is_subnormal(float(value)))
        value = 0;
    return std::clamp(value, p.low, p.high);
}

} // namespace

std::string item(const Parameter& p, double value) {
    value = within_range(p, value);
    // Sliders stop between the two that stand for something, and between them and 0.
    if (p.initial == filters_own && value < 0)
        value = value < (by_name + filters_own) / 2 ? p.low : filters_own;
    if (value == p.initial)
        return "";
    std::string text;
    switch (p.kind) {
    case OptionKind::real:
        text = value == by_name && p.low == by_name ? p.option->values.front().name
                                                    : number_text(float(value));
        break;
    case OptionKind::choice:
        text = p.names[size_t(value)];
        break;
    default:
        text = std::to_string(std::llround(value));
    }
    return std::string(",") + p.option->key + "=" + text;
}

} // namespace ddt::host
