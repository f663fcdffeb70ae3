// SPDX-License-Identifier: Apache-2.0
// What `ddt` exits with, and failures that know it.
#pragma once

#include <string>

namespace ddt::tool {

/// Besides these a shell sees 128 plus the number of a signal that ended the program.
enum ExitCode {
    exit_done = 0,
    exit_failed = 1,    ///< something cannot be read, made or written; trying again would not help
    exit_usage = 2,     ///< the command line is wrong
    exit_resources = 3, ///< memory, disk, network or device are wanting; trying again may help
};

/// Why something was not done, in one line.
struct Failure {
    std::string why;
    ExitCode code = exit_failed;
};

/// The code for a failed system call: exit_resources where it says that something ran out or is in
/// use, or that a device or the way to it failed.
ExitCode code_of_errno(int number);

/// The failure that the exception which is being handled tells of.
Failure thrown();

/// The code for a failure of the library, which tells it by a text alone: by what this says beside
/// the names it has in double quotes.
ExitCode code_of_message(const std::string& message);

} // namespace ddt::tool
