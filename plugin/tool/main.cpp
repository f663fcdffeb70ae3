// SPDX-License-Identifier: Apache-2.0
// ddt: triangulates pictures by their content. Commands are in commands.h.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <OpenImageIO/imageio.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/file/unfinished.h"
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

ExitCode run_caught(const std::vector<std::string>& args) {
    try {
        return run(args);
    } catch (const std::exception&) {
        return fail(thrown());
    }
}

/// What a library throws where nobody can catch it, in a thread or a destructor of its own.
[[noreturn]] void end_uncaught() {
    remove_unfinished();
    // Where it is not known what was thrown, in a function that must not throw, it was for want of
    // memory.
    if (!std::current_exception() && std::uncaught_exceptions() > 0)
        end_without_memory();
    if (!std::current_exception())
        std::abort();
    try {
        std::_Exit(fail(thrown()));
    } catch (const std::bad_alloc&) {
        end_without_memory();
    }
}

/// The next file to be opened would get the number of one that is closed, and what is meant for a
/// terminal would be written into it. The standard input for writing, and the output for reading:
/// to use them fails then, where an end would pass for a stream without pictures, and what nobody
/// gets for printed.
void open_closed_streams() {
    for (int descriptor = 0; descriptor <= 2; ++descriptor)
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) [[maybe_unused]]
            const int opened = open("/dev/null", descriptor == STDOUT_FILENO ? O_RDONLY : O_WRONLY);
}

/// That a reader has seen enough (ddt info | head) is no fault.
bool reader_has_gone() {
    pollfd out{STDOUT_FILENO, 0, 0};
    return poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

/// Why a write failed of which nobody kept the error's number: what a byte more is told, which
/// comes after what is incomplete anyway. 0 if that one arrives.
int error_of_output() {
    return write(STDOUT_FILENO, "\n", 1) < 0 ? errno : 0;
}

/// What was printed must have arrived. The first failure counts.
ExitCode finish_output(ExitCode code) {
    errno = 0;
    if (std::fflush(stdout) == 0 && !std::ferror(stdout))
        return code;
    const int number = errno;
    if (code != exit_done || reader_has_gone())
        return code;
    return fail(why_not_printed(number ? number : error_of_output()), exit_resources);
}

/// Libraries may lack what they count on after they had no memory: as the program ends,
/// OpenImageIO's cache for all finds tiles that nobody finished, and aborts.
ExitCode finish(ExitCode code) {
    code = finish_output(code);
    if (code == exit_resources) {
        remove_unfinished();
        std::_Exit(code);
    }
    return code;
}

} // namespace
} // namespace ddt::tool

int main(int argc, char** argv) {
    using namespace ddt::tool;
    open_closed_streams();
    remove_unfinished_on_signals();
    std::set_terminate(end_uncaught);
    OIIO::attribute("debug", 0); // its builds may print what is an error's text anyway
    return finish(run_caught({argv + 1, argv + argc}));
}
