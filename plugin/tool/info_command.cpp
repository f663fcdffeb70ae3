// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <OpenColorIO/OpenColorIO.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include "core/base/one_line.h"
#include "ddt/devices.h"
#include "ddt/names.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/filter_flag.h"
#include "plugin/tool/command/threads.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/plugin_file.h"

namespace ddt::tool {

namespace {

class InfoCommand final : public Command {
public:
    InfoCommand() {
        name = "info";
        summary = "Print versions, devices and what the filters' options allow";
        paragraphs = {
            "A device that cannot be used is listed with the reason.",
            "Of the plugin it tells which functions of OpenImageIO are redirected in this "
            "program, and what could not be."};
    }

    ExitCode run(const std::vector<std::string>&) override {
        line("ddt", DDT_VERSION);
        line("OpenImageIO", format("{} (built with {})", OIIO_version(OIIO::openimageio_version()),
                                   OIIO_VERSION_STRING));
        line("OpenColorIO", OCIO_NAMESPACE::GetVersion());
        for (const std::string& text : describe_plugin())
            line("plugin", text);
        const char* config = std::getenv("OCIO");
        line("OCIO config", describe_config(config));
        const int threads = planned_threads(0);
        line("cpu", format("{} thread{}", threads, threads == 1 ? "" : "s"));
        for (const Device device : {Device::egl, Device::osmesa})
            line(device_name(device), describe_device(device));
        line("auto", automatic_device());
        std::printf("\n%s", filter_notes().c_str());
        return exit_done;
    }

private:
    /// Its name, and why it cannot be read, if it cannot.
    static std::string describe_config(const char* path) {
        if (!path || !*path)
            return "none in $OCIO; the one built in";
        try {
            OCIO_NAMESPACE::Config::CreateFromFile(path);
            return path;
        } catch (const OCIO_NAMESPACE::Exception& e) {
            return format("{} (cannot be read: {})", path, one_line(e.what()));
        }
    }

    /// The renderer, or why there is none.
    static std::string describe_device(Device device) {
        Job job;
        job.device = device;
        std::string text;
        if (!ddt::describe_device(job, text))
            return "not used: " + reason_in(without_prefix(text));
        return text;
    }
    /// What an error says after its first ": ", or all of it.
    static std::string reason_in(const std::string& error) {
        const size_t colon = error.find(": ");
        return colon == std::string::npos ? error : error.substr(colon + 2);
    }
    /// What a large image is worked on when no device is named.
    static std::string automatic_device() {
        Job job;
        job.window = {0, 0, 32768, 32768};
        std::string text;
        if (!ddt::describe_device(job, text))
            return "not used: " + without_prefix(text);
        return text +
               " (for a large image; small ones, schemes a GPU does not know, and machines whose "
               "only renderer is software use the cpu)";
    }
    static std::string OIIO_version(int v) {
        return format("{}.{}.{}", v / 10000, v / 100 % 100, v % 100);
    }
    static void line(const char* what, const std::string& text) {
        std::printf("%-12s %s\n", what, text.c_str());
    }
};

} // namespace

std::unique_ptr<Command> make_info_command() {
    return std::make_unique<InfoCommand>();
}

} // namespace ddt::tool
