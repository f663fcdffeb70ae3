// SPDX-License-Identifier: Apache-2.0
// README.md's table of options is that of the library.
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "ddt/names.h"
#include "ddt/option_table.h"

namespace ddt::test {
namespace {

std::string code(const std::string& text) {
    return "`" + text + "`";
}

/// "0 to 0.25", "0 or 1", "one of:"
std::string range_of(const Option& option) {
    switch (option.kind) {
    case OptionKind::real:
        return number_text(float(option.low)) + " to " + number_text(float(option.high));
    case OptionKind::whole:
        return std::to_string(int64_t(option.low)) + " to " + std::to_string(int64_t(option.high));
    case OptionKind::toggle:
        return "0 or 1";
    case OptionKind::choice:
    case OptionKind::text:
        return option.others.empty() ? "one of:" : "one of these, or " + option.others + ":";
    }
    return "";
}

/// "`0.07`; `0` in `ddt-linear`"
std::string defaults_of(const Option& option) {
    const std::string own = default_text(option, filter_names()[0]);
    std::string text = code(own);
    for (const std::string& filter : filter_names())
        if (default_text(option, filter) != own)
            text += "; " + code(default_text(option, filter)) + " in " + code(filter);
    return text;
}

std::string rows() {
    std::string text;
    for (const Option& option : option_table()) {
        text += "| " + code(option.key) + " | " + range_of(option) + " | " + defaults_of(option) +
                " | " + option.help + " |\n";
        for (const NamedValue& value : option.values)
            text += "| | " + code(value.name) + " | | " + value.help + " |\n";
    }
    return text;
}

TEST(Readme, ListsTheOptionsAsTheyAre) {
    std::ifstream file(DDT_README);
    std::string line, found;
    while (std::getline(file, line) && line.rfind("| option |", 0) != 0) {
    }
    std::getline(file, line); // |---|
    while (std::getline(file, line) && !line.empty())
        found += line + "\n";
    EXPECT_EQ(found, rows()) << "put these rows into README.md:\n" << rows();
}

} // namespace
} // namespace ddt::test
