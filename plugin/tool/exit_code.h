// SPDX-License-Identifier: Apache-2.0
// What `ddt` exits with, and failures that know it.
#pragma once

#include <string>

namespace ddt::tool {

/// A signal that ends the program makes a shell see 128 plus its number beside these.
enum ExitCode {
    exit_done = 0,
    exit_failed = 1,    ///< something cannot be read, made or written; trying again would not help
    exit_usage = 2,     ///< the command line is wrong
    exit_resources = 3, ///< memory, disk or device are wanting; trying again may help
};

/// Why something was not done, in one line.
struct Failure {
    std::string why;
    ExitCode code = exit_failed;
};

/// The code for a failed system call: exit_resources for those that say that something ran out or
/// a device failed.
ExitCode code_of_errno(int number);

/// What the exception says that is being handled.
Failure thrown();

/// The code for a message of the library, which are text alone.
ExitCode code_of_message(const std::string& message);

} // namespace ddt::tool
