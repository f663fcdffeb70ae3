// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/progress.h"
#include "plugin/tool/command/threads.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/part/join.h"

namespace ddt::tool {

namespace {

class JoinCommand final : public Command {
public:
    JoinCommand() {
        name = "join";
        summary = "Join the parts that resize --part wrote";
        paragraphs = {
            "The same pixels and metadata as those of one run without parts, where OUT's format "
            "has the parts' pixel type; else they are rounded once more. Parts that are missing, "
            "there twice or of another job are refused. Of a source larger than 64 MiB this is "
            "judged by 64 MiB of its bytes, evenly spread."};
        operands = {{"PART...", "all parts, in any order"},
                    {"OUT", "any image OpenImageIO writes; large ones want EXR or TIFF"}};
        flags = {progress_flag(m_progress)};
    }

    ExitCode run(const std::vector<std::string>& values) override {
        share_threads(0);
        Progress progress("joining", progress_mode(m_progress));
        Failure failure;
        if (join({values.begin(), values.end() - 1}, values.back(), std::ref(progress), failure))
            return exit_done;
        progress.hide();
        return fail(failure);
    }

private:
    std::string m_progress = "auto";
};

} // namespace

std::unique_ptr<Command> make_join_command() {
    return std::make_unique<JoinCommand>();
}

} // namespace ddt::tool
