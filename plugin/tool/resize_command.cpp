// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <OpenImageIO/filesystem.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/picture.h"
#include "plugin/tool/progress.h"
#include "plugin/tool/size.h"

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
            "50%, 50%x75%; 2.5 is a factor. They are those of the display window."};
        operands = {{"IN", "any image OpenImageIO reads"},
                    {"SIZE", "size of the result"},
                    {"OUT", "any image OpenImageIO writes"}};
        flags = {
            {"--filter", "SPEC",
             "the filter's name and options (default: ddt): ddt-sharp,light=encoded",
             [this](const std::string& text) {
                 parse_filter(text, m_options, m_filter_error);
                 return true;
             },
             ""},
            choice_flag("--type", {"uint8", "uint16", "half", "float"},
                        "pixel type of the result (default: the image's)", m_type),
            whole_flag("--threads", "N", "threads to use (default: all cores)", 0, 4096, m_threads),
        };
    }

    ExitCode run(const std::vector<std::string>& values) override {
        if (!m_filter_error.empty())
            return fail(m_filter_error, exit_usage);
        OIIO::ImageBuf image;
        std::string error;
        if (!open_image(values[0], image, error))
            return fail(error);
        OIIO::ImageBuf result;
        if (!prepare(image.spec(), values[1], result))
            return fail("size \"" + values[1] + "\" is not allowed; allowed are " + allowed_sizes,
                        exit_usage);
        {
            Progress progress("resizing");
            m_options.progress = std::ref(progress);
            if (!resize(result, image, m_options, result.roi(), m_threads))
                return fail(result.geterror());
        }
        return write(result, values[2]);
    }

private:
    /// The windows that oiiotool makes: the size is the display window's; the data window is scaled
    /// along with it, its origin rounded down, its size up. Of a size that does not change, neither
    /// does the origin.
    bool prepare(const OIIO::ImageSpec& from, const std::string& text,
                 OIIO::ImageBuf& result) const {
        Size size;
        if (!parse_size(text, {from.full_width, from.full_height, from.full_x, from.full_y}, size))
            return false;
        OIIO::ImageSpec spec = from;
        if (size.width != from.full_width || size.height != from.full_height) {
            const double across = double(size.width) / from.full_width;
            const double down = double(size.height) / from.full_height;
            spec.x = size.x + int(std::floor((from.x - from.full_x) * across));
            spec.y = size.y + int(std::floor((from.y - from.full_y) * down));
            spec.width = int(std::ceil(from.width * across));
            spec.height = int(std::ceil(from.height * down));
            spec.full_x = size.x;
            spec.full_y = size.y;
            spec.full_width = size.width;
            spec.full_height = size.height;
        }
        if (!m_type.empty()) {
            spec.set_format(OIIO::TypeDesc(m_type));
            spec.channelformats.clear();
        }
        result.reset(spec);
        return true;
    }

    static ExitCode write(OIIO::ImageBuf& result, const std::string& path) {
        Progress progress("writing");
        const auto callback = [](void* data, float share) {
            (*static_cast<Progress*>(data))(share);
            return false; // do not stop
        };
        const bool was_there = OIIO::Filesystem::exists(path);
        if (result.write(path, OIIO::TypeUnknown, "", callback, &progress))
            return exit_done;
        const std::string why = result.geterror();
        if (!was_there)
            OIIO::Filesystem::remove(path);
        return fail(why.empty() ? "cannot write \"" + path + "\"" : why);
    }

    Options m_options;
    std::string m_filter_error, m_type;
    int m_threads = 0;
};

} // namespace

std::unique_ptr<Command> make_resize_command() {
    return std::make_unique<ResizeCommand>();
}

} // namespace ddt::tool
