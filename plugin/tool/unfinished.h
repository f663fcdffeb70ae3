// SPDX-License-Identifier: Apache-2.0
// Files that go when a signal ends the program.
#pragma once

#include <string>

namespace ddt::tool {

/// From now on SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGXCPU remove the files listed, and then end
/// the program as they would have. SIGXFSZ and SIGPIPE are ignored: writing fails instead, which
/// is told. A library that ends the program by exit() leaves none either. Once, at the start.
void remove_unfinished_on_signals();

/// List a file; a number for unlist(), or -1 if the list is full (64 at once). Thread-safe.
int list_unfinished(const std::string& path);
void unlist_unfinished(int number);

} // namespace ddt::tool
