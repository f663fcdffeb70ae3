// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/command.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <unistd.h>

#include <OpenImageIO/argparse.h>
#include <OpenImageIO/strutil.h>

#include "core/base/one_line.h"
#include "core/base/parse_number.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

bool takes_more(const Command& command) {
    return std::any_of(
        command.operands.begin(), command.operands.end(),
        [](const Operand& operand) { return OIIO::Strutil::ends_with(operand.name, "..."); });
}

/// What may have been meant by the option that a message has in quotes: "; did you mean --filter?",
/// or nothing.
std::string near_option(const std::string& message, const std::vector<Flag>& flags) {
    constexpr size_t most = 2; // two letters that changed places
    const size_t begin = message.find('"') + 1, end = message.find('"', begin);
    if (begin == 0 || end == std::string::npos)
        return "";
    const std::string text = message.substr(begin, end - begin);
    const size_t equals = text.find('=');
    const std::string given = text.substr(0, equals);
    const auto distance = [&](const Flag& flag) {
        return OIIO::Strutil::edit_distance(given, flag.name);
    };
    const auto nearer = [&](const Flag& a, const Flag& b) { return distance(a) < distance(b); };
    const auto nearest = std::min_element(flags.begin(), flags.end(), nearer);
    // One that is spelt right was not understood for another reason.
    if (equals != std::string::npos && nearest != flags.end() && distance(*nearest) == 0)
        return "; " + given + " has no value";
    return nearest != flags.end() && distance(*nearest) > 0 && distance(*nearest) <= most
               ? "; did you mean " + nearest->name + "?"
               : "";
}

/// The arguments with "--name=value" of a flag that has a value as the two that it stands for;
/// OpenImageIO's parser does not know it. What is a value itself stays as it is.
std::vector<std::string> split_values(const std::vector<std::string>& args,
                                      const std::vector<Flag>& flags) {
    const auto has_value = [&](const std::string& name) {
        return std::any_of(flags.begin(), flags.end(), [&](const Flag& flag) {
            return flag.name == name && !flag.value.empty();
        });
    };
    std::vector<std::string> split;
    bool is_value = false;
    for (const std::string& arg : args) {
        const size_t equals = arg.find('=');
        if (!is_value && equals != std::string::npos && has_value(arg.substr(0, equals))) {
            split.push_back(arg.substr(0, equals));
            split.push_back(arg.substr(equals + 1));
            continue;
        }
        is_value = !is_value && has_value(arg);
        split.push_back(arg);
    }
    return split;
}

/// Hand the command's flags to OpenImageIO's parser, which also prints them for --help.
class Parser {
public:
    explicit Parser(Command& command) : m_command(command) {
        m_args.usage(usage(command)).exit_on_error(false).add_help(false);
        m_args.intro(format("ddt {}: {}", command.name, command.summary));
        std::string description;
        for (const std::string& paragraph : command.paragraphs)
            description += OIIO::Strutil::wordwrap(paragraph, 80) + "\n\n";
        for (const Operand& operand : command.operands)
            description += format("  {:<8} {}\n", operand.name, operand.help);
        m_args.description(description);
        m_args.arg("operand").hidden().action(
            [this](OIIO::cspan<const char*> a) { m_operands.emplace_back(a[0]); });
        std::string notes;
        for (const Flag& flag : command.flags) {
            add(flag);
            if (!flag.notes.empty())
                notes += "\n" + flag.notes;
        }
        m_args.epilog(notes);
        const auto ask_for_help = [this](OIIO::cspan<const char*>) { m_help = true; };
        m_args.arg("--help").help("print this and end").action(ask_for_help);
        m_args.arg("-h").hidden().action(ask_for_help);
    }

    ExitCode parse_and_run(const std::vector<std::string>& args) {
        const auto end_of_options = std::find(args.begin(), args.end(), "--");
        const std::vector<std::string> options =
            split_values({args.begin(), end_of_options}, m_command.flags);
        std::vector<const char*> pointers{"ddt"};
        for (const std::string& option : options)
            pointers.push_back(option.c_str());
        const int status = m_args.parse_args(int(pointers.size()), pointers.data());
        if (m_help) {
            m_args.print_help();
            return exit_done;
        }
        if (status < 0)
            return wrong_option(m_args.geterror());
        if (!m_error.empty())
            return wrong(m_error);
        if (end_of_options != args.end())
            m_operands.insert(m_operands.end(), end_of_options + 1, args.end());
        const bool more = takes_more(m_command),
                   few = m_operands.size() < m_command.operands.size();
        if (few || (m_operands.size() > m_command.operands.size() && !more))
            return wrong(format("{} takes {} arguments{}, not {}", m_command.name,
                                m_command.operands.size(), more ? " or more" : "",
                                m_operands.size()));
        return m_command.run(m_operands);
    }

private:
    void add(const Flag& flag) {
        const std::string spec = flag.value.empty() ? flag.name : flag.name + " %s:" + flag.value;
        m_args.arg(spec.c_str()).help(flag.help).action([this, &flag](OIIO::cspan<const char*> a) {
            const std::string value = a.size() > 1 ? a[1] : "";
            if (m_error.empty() && !flag.set(value))
                m_error = format("\"{} {}\" is not allowed; allowed are {}", flag.name, value,
                                 flag.allowed);
        });
    }

    ExitCode wrong_option(const std::string& said) const {
        const std::string why(OIIO::Strutil::strip(said));
        // Some versions of the parser say it themselves.
        const bool said_near = why.find("did you mean") != std::string::npos;
        return wrong(said_near ? why : why + near_option(why, m_command.flags));
    }

    ExitCode wrong(const std::string& why) const {
        fail(why, exit_usage);
        std::fprintf(stderr, "usage: %s\n", usage(m_command).c_str());
        return exit_usage;
    }

    Command& m_command;
    OIIO::ArgParse m_args;
    std::vector<std::string> m_operands;
    std::string m_error;
    bool m_help = false;
};

} // namespace

std::string usage(const Command& command) {
    std::string text = "ddt " + command.name + " [options]";
    for (const Operand& operand : command.operands)
        text += " " + operand.name;
    return text;
}

ExitCode parse_and_run(Command& command, const std::vector<std::string>& args) {
    return Parser(command).parse_and_run(args);
}

void note(const std::string& message) {
    std::fprintf(stderr, "%s\n", with_prefix(one_line(message)).c_str());
}

void note(const std::vector<std::string>& messages) {
    for (const std::string& message : messages)
        note(message);
}

ExitCode fail(const std::string& message, ExitCode code) {
    note(message);
    return code;
}

ExitCode fail(const Failure& failure) {
    return fail(failure.why, failure.code);
}

void tell(const std::string& message) {
    // Not by the stream: what that keeps back fails once more at the end, when nobody knows whose
    // it was. That a reader has seen enough is no fault.
    if (dprintf(STDOUT_FILENO, "%s\n", message.c_str()) < 0 && errno != EPIPE)
        note(why_not_printed(errno));
}

std::string why_not_printed(int number) {
    return "the standard output cannot be written" +
           (number ? std::string(": ") + std::strerror(number) : "");
}

Flag number_flag(const char* name, const char* value, const char* help, double low, double high,
                 double& number) {
    return {name,
            value,
            format("{}; {} to {}", help, low, high),
            [=, &number](const std::string& text) { return parse_number(text, low, high, number); },
            format("numbers from {} to {}", low, high),
            ""};
}

Flag whole_flag(const char* name, const char* value, const char* help, int low, int high,
                int& number) {
    return {name,
            value,
            format("{}; {} to {}", help, low, high),
            [=, &number](const std::string& text) { return parse_number(text, low, high, number); },
            format("whole numbers from {} to {}", low, high),
            ""};
}

Flag choice_flag(const char* name, const std::vector<std::string>& choices, const char* help,
                 std::string& choice) {
    return {name,
            OIIO::Strutil::join(choices, "|"),
            help,
            [=, &choice](const std::string& text) {
                choice = text;
                return std::find(choices.begin(), choices.end(), text) != choices.end();
            },
            OIIO::Strutil::join(choices, ", "),
            ""};
}

Flag text_flag(const char* name, const char* value, const char* help, std::string& text) {
    return {name,
            value,
            help,
            [&text](const std::string& given) {
                text = given;
                return !given.empty();
            },
            "texts that are not empty",
            ""};
}

Flag switch_flag(const char* name, const char* help, bool& on) {
    return {name, "", help, [&on](const std::string&) { return on = true; }, "", ""};
}

Flag progress_flag(std::string& mode) {
    return choice_flag("--progress", {"auto", "lines", "none"},
                       "a bar on a terminal (auto), lines for programs, or nothing", mode);
}

} // namespace ddt::tool
