// SPDX-License-Identifier: Apache-2.0
// The commands of `ddt`, and the one description of each from which its arguments are read, its
// --help is printed and the man page is made.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// An option of a command: "--height", and the name of its value in help, empty if it has none.
struct Flag {
    std::string name, value, help;
    /// Take the value; false if it is not allowed.
    std::function<bool(const std::string&)> set;
    std::string allowed; ///< for the error message
    std::string notes;   ///< printed after all flags by --help
};

/// One whose name ends in "..." stands for one or more values.
struct Operand {
    std::string name, help;
};

/// A command to be run once.
class Command {
public:
    virtual ~Command() = default;
    std::string name;
    std::string summary;                 ///< a line without full stop
    std::vector<std::string> paragraphs; ///< of its description
    std::vector<Operand> operands;
    std::vector<Flag> flags;

    /// `values`: one an operand, or more where that stands for more. Errors go to stderr as a line
    /// after "ddt: ".
    virtual ExitCode run(const std::vector<std::string>& values) = 0;
};

/// "ddt mesh [options] IN OUT"
std::string usage(const Command& command);

/// Read the command's arguments, args[0] being the first after its name, and run it. A flag's value
/// is the next argument, or follows its name after =.
ExitCode parse_and_run(Command& command, const std::vector<std::string>& args);

/// A line on stderr, after "ddt: " unless it starts so.
void note(const std::string& message);
/// One of each.
void note(const std::vector<std::string>& messages);
/// The same of what failed.
ExitCode fail(const std::string& message, ExitCode code = exit_failed);
ExitCode fail(const Failure& failure);

/// A line on stdout about a result that is a file: where it cannot be printed that is said, and no
/// failure.
void tell(const std::string& message);
/// That a write to stdout failed, with the error's number or 0.
std::string why_not_printed(int number);

/// Flags that hold a number from low to high, which their help tells, or are set when given.
Flag number_flag(const char* name, const char* value, const char* help, double low, double high,
                 double& number);
Flag whole_flag(const char* name, const char* value, const char* help, int low, int high,
                int& number);
Flag choice_flag(const char* name, const std::vector<std::string>& choices, const char* help,
                 std::string& choice);
Flag text_flag(const char* name, const char* value, const char* help, std::string& text);
Flag switch_flag(const char* name, const char* help, bool& on);

/// --progress, whose value `mode` names one for progress_mode().
Flag progress_flag(std::string& mode);

} // namespace ddt::tool
