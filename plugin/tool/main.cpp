// SPDX-License-Identifier: Apache-2.0
// ddt: triangulates pictures by their content. Commands are in commands.h.
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "plugin/tool/commands.h"
#include "plugin/tool/man.h"

namespace ddt::tool {

namespace {

ExitCode run(const std::vector<std::string>& args) {
    const auto commands = make_commands();
    const std::string name = args.empty() ? "" : args[0];
    for (const auto& command : commands)
        if (command->name == name)
            return parse_and_run(*command, {args.begin() + 1, args.end()});
    // --man is how the build makes the manual page.
    if (name == "--help" || name == "-h" || name == "--man") {
        std::fputs((name == "--man" ? man_page(commands) : overview(commands)).c_str(), stdout);
        return exit_done;
    }
    if (name == "--version") {
        std::printf("ddt %s\n", DDT_VERSION);
        return exit_done;
    }
    std::fputs(overview(commands).c_str(), stderr);
    return name.empty() ? exit_usage : fail("unknown command \"" + name + "\"", exit_usage);
}

} // namespace
} // namespace ddt::tool

int main(int argc, char** argv) {
    using namespace ddt::tool;
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::bad_alloc&) {
        return fail("out of memory");
    } catch (const std::exception& e) {
        return fail(e.what());
    }
}
