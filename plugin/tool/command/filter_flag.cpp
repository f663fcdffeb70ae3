// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/filter_flag.h"

#include <algorithm>

#include <OpenImageIO/strutil.h>

#include "ddt/names.h"
#include "ddt/option_table.h"
#include "plugin/image/reading.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

/// Terminals have no `code`.
std::string plain(const char* help) {
    return OIIO::Strutil::replace(help, "`", "", true);
}

/// "0.07, ddt-linear 0, ddt-sharp 0.05"
std::string defaults_of(const Option& option) {
    const std::vector<std::string> filters = filter_names();
    const std::string own = default_text(option, filters[0]);
    std::string text = own;
    for (const std::string& filter : filters)
        if (default_text(option, filter) != own)
            text += format(", {} {}", filter, default_text(option, filter));
    return text;
}

} // namespace

Flag filter_flag(const char* help, Options& options, std::string& error, std::string* given,
                 const std::vector<std::string>& counting) {
    return {"--filter",
            "SPEC",
            help,
            [&options, &error, given](const std::string& text) {
                if (given)
                    *given = text;
                error.clear(); // the last of several counts
                parse_filter(text, options, error);
                return true;
            },
            "",
            filter_notes(counting)};
}

std::vector<Entry> filter_entries() {
    std::vector<Entry> entries;
    for (const std::string& filter : filter_names())
        entries.push_back({filter, plain(filter_help(filter).c_str())});
    for (const Option& option : option_table()) {
        std::string meaning = format("{} Allowed: {}. Default: {}.", plain(option.help),
                                     option.allowed(), defaults_of(option));
        for (const NamedValue& value : option.values)
            meaning += format(" {}: {}", value.name, plain(value.help));
        entries.push_back({option.key + std::string("="), meaning});
    }
    return entries;
}

bool check_light_name(const Options& options, std::string& error) {
    const OIIO::ImageSpec none;
    return check_light(none, none, options, error);
}

std::string filter_notes(const std::vector<std::string>& counting) {
    constexpr int columns = 80, indent = 14;
    const auto counts = [&](const Entry& entry) {
        return counting.empty() || std::any_of(counting.begin(), counting.end(),
                                               [&](auto& key) { return entry.term == key + "="; });
    };
    std::string text =
        counting.empty() ? "Filters and options (SPEC is a filter's name, or ddt,key=value,...):\n"
                         : "Options (SPEC is a filter's name, or ddt,key=value,...; others than "
                           "these\nchange nothing here):\n";
    for (const Entry& entry : filter_entries()) {
        if (!counts(entry))
            continue;
        text += format("  {:<11} {}\n", entry.term,
                       OIIO::Strutil::wordwrap(entry.meaning, columns - 2, indent));
    }
    return text;
}

} // namespace ddt::tool
