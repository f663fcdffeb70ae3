// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/commands.h"
#include "plugin/tool/filter_flag.h"
#include "plugin/tool/progress.h"
#include "plugin/tool/resize_file.h"

namespace ddt::tool {

namespace {

class ResizeCommand final : public Command {
public:
    ResizeCommand() {
        name = "resize";
        summary = "Resize an image";
        paragraphs = {
            "The same pixels as oiiotool IN --resize:filter=ddt SIZE -o OUT with the plugin.",
            "Sizes are oiiotool's: 640x480; 0x480 keeps the shape; 640x480+10-20 moves the origin; "
            "50%, 50%x75%; 2.5 is a factor. They are those of the display window.",
            "OUT appears under its name when it is whole; until then what was there stays there."};
        operands = {{"IN", "any image OpenImageIO reads"},
                    {"SIZE", "size of the result"},
                    {"OUT", "any image OpenImageIO writes"}};
        flags = {
            filter_flag("the filter's name and options (default: ddt): ddt-sharp,light=encoded",
                        m_settings.options, m_filter_error),
            choice_flag("--type", {"uint8", "uint16", "half", "float"},
                        "pixel type of the result (default: the image's)", m_settings.type),
            whole_flag("--threads", "N", "threads to use (default: all cores)", 0, 4096,
                       m_settings.threads),
            progress_flag(m_progress),
        };
    }

    ExitCode run(const std::vector<std::string>& values) override {
        if (!m_filter_error.empty())
            return fail(m_filter_error, exit_usage);
        m_settings.size = values[1];
        Progress progress("resizing", progress_mode(m_progress));
        Failure failure;
        if (resize_file(values[0], values[2], m_settings, std::ref(progress), failure))
            return exit_done;
        progress.hide();
        return fail(failure);
    }

private:
    ResizeSettings m_settings;
    std::string m_filter_error, m_progress = "auto";
};

} // namespace

std::unique_ptr<Command> make_resize_command() {
    return std::make_unique<ResizeCommand>();
}

} // namespace ddt::tool
