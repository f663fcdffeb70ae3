// SPDX-License-Identifier: Apache-2.0
// The flag --filter, and the filters and their options in words.
#pragma once

#include <string>
#include <vector>

#include "ddt/resize.h"
#include "plugin/tool/command/command.h"

namespace ddt::tool {

/// A flag whose value is a specification. One that does not parse puts its line, which says more
/// than a list of values, into `error`, which is to be looked at before the command does anything.
/// `given`, if not null, is the text itself. `counting`: filter_notes() of these.
Flag filter_flag(const char* help, Options& options, std::string& error,
                 std::string* given = nullptr, const std::vector<std::string>& counting = {});

/// False with one line in `error` unless there is the light that the options name, for commands
/// that may have no use for it.
bool check_light_name(const Options& options, std::string& error);

/// A term and what it means.
struct Entry {
    std::string term, meaning;
};
/// The filters, the options with what is allowed and their defaults, the named values.
std::vector<Entry> filter_entries();

/// filter_entries() for a terminal; or, if there are any, of the options of these keys alone, for a
/// command to which no others mean anything.
std::string filter_notes(const std::vector<std::string>& counting = {});

} // namespace ddt::tool
