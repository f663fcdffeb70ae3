// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/man.h"

#include <OpenImageIO/strutil.h>

#include "ddt/names.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/filter_flag.h"
#include "plugin/tool/plugin_file.h"

namespace ddt::tool {

namespace {

constexpr const char* about = "triangulates pictures by their content";

struct Code {
    ExitCode code;
    const char* meaning;
};
constexpr Code codes[] = {
    {exit_done, "Done."},
    {exit_failed, "Something cannot be read, made or written, and trying again will not help; a "
                  "line on standard error tells. No unfinished file is left."},
    {exit_usage, "The command line is wrong. Nothing was done, but frames of a sequence for which "
                 "it was right."},
    {exit_resources, "Memory, disk, network or device were wanting, or failed, or a file was "
                     "changed while it was read: trying again, or on another machine, may help. No "
                     "unfinished file is left."},
};

constexpr const char* by_signal =
    "As a shell sees it: ended by signal N. No unfinished file is left, but by KILL (N is 9) or a "
    "crash: a hidden one, which the next run of the same user that writes the same OUT removes.";

struct Variable {
    const char* name;
    std::string meaning;
};
/// What of the environment ddt itself or the libraries below it look at, and users may want to set.
std::vector<Variable> variables() {
    return {
        {"DDT_DEVICE", format("The device where --filter names none: {}.",
                              OIIO::Strutil::join(device_names(), ", "))},
        {"DDT_EGL_DEVICE",
         "The number of the GPU to use, from 0 among those that EGL lists. Unless "
         "set, the first that opens."},
        {"DDT_VERBOSE", "What is neither empty nor begins with 0 (no counts as on, too): lines on "
                        "standard error tell which device worked, and why another did not."},
        {"OCIO", "OpenColorIO's config, which names colour spaces. Unless set, one that is built "
                 "in."},
        {plugin_path_variable,
         "Folders, with colons between them, in which OpenImageIO looks for plugins: for those of "
         "more file formats, and, in other programs, for these filters, which ddt has without."},
        {"OPENIMAGEIO_OPTIONS", "Attributes of OpenImageIO, such as limits:imagesize_MB=1024, the "
                                "most that an image may take."},
        {"OPENIMAGEIO_THREADS",
         "How many threads resize, fill and join use where no --threads says so; ddt info tells "
         "the number. Unless set, or 0, all cores, in a container its quota."},
    };
}

/// Text as man(7) takes it: backslashes and hyphens escaped, no line that starts with a control
/// character.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    return out.empty() || (out[0] != '.' && out[0] != '\'') ? out : "\\&" + out;
}

} // namespace

std::string man_page(const std::vector<std::unique_ptr<Command>>& commands) {
    std::string page = format(".TH DDT 1 \"\" \"oiio-ddt {}\" \"User Commands\"\n", DDT_VERSION);
    page += format(".SH NAME\nddt \\- {}\n.SH SYNOPSIS\n", about);
    for (const auto& command : commands)
        page += format(".B {}\n.br\n", escaped(usage(*command)));
    page += ".B ddt \\-\\-help\n.br\n.B ddt \\-\\-version\n.SH COMMANDS\n"
            "An option's value is the next argument, or follows its name after = "
            "(\\-\\-filter=ddt\\-sharp). "
            "After \\-\\- all arguments are operands, whatever they begin with.\n";
    for (const auto& command : commands) {
        page += format(".SS {}\n{}.\n", escaped(usage(*command)), escaped(command->summary));
        for (const std::string& paragraph : command->paragraphs)
            page += format(".PP\n{}\n", escaped(paragraph));
        for (const Operand& operand : command->operands)
            page += format(".TP\n.I {}\n{}\n", escaped(operand.name), escaped(operand.help));
        for (const Flag& flag : command->flags)
            page += format(".TP\n.BR {}{}\n{}\n", escaped(flag.name),
                           flag.value.empty() ? "" : " \" \\fI" + escaped(flag.value) + "\\fP\"",
                           escaped(flag.help));
    }
    page += ".SH FILTERS AND OPTIONS\nSPEC is a filter's name, or \"ddt,key=value,...\".\n";
    for (const Entry& entry : filter_entries())
        page += format(".TP\n.B {}\n{}\n", escaped(entry.term), escaped(entry.meaning));
    page += ".SH EXIT STATUS\n";
    for (const Code& code : codes)
        page += format(".TP\n.B {}\n{}\n", int(code.code), escaped(code.meaning));
    page += format(".TP\n.B 128 + N\n{}\n", escaped(by_signal));
    page += ".SH ENVIRONMENT\n";
    for (const Variable& variable : variables())
        page += format(".TP\n.B {}\n{}\n", variable.name, escaped(variable.meaning));
    page += ".SH SEE ALSO\n.BR oiiotool (1)\n";
    return page;
}

std::string overview(const std::vector<std::unique_ptr<Command>>& commands) {
    std::string text = format("ddt {}: {}\n\nusage:\n", DDT_VERSION, about);
    for (const auto& command : commands)
        text += format("  {:<38} {}\n", usage(*command), command->summary);
    text += "  ddt COMMAND --help\n  ddt --help | --version\n\nexit status:\n";
    for (const Code& code : codes)
        text += format("  {}  {}\n", int(code.code), OIIO::Strutil::wordwrap(code.meaning, 76, 5));
    text += format("  128 + N  {}\n", OIIO::Strutil::wordwrap(by_signal, 76, 11));
    text += "\nenvironment:\n";
    for (const Variable& variable : variables())
        text += format("  {}\n     {}\n", variable.name,
                       OIIO::Strutil::wordwrap(variable.meaning, 76, 5));
    return text;
}

} // namespace ddt::tool
