// SPDX-License-Identifier: Apache-2.0
#include "plugin/message/format.h"
#include "plugin/tool/command/filter_flag.h"
#include "plugin/tool/command/progress.h"
#include "plugin/tool/command/threads.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/file/compression.h"
#include "plugin/tool/file/reading_errors.h"
#include "plugin/tool/part/resize_part.h"
#include "plugin/tool/resize/resize_file.h"
#include "plugin/tool/resize/size.h"
#include "plugin/tool/sequence/sequence.h"

namespace ddt::tool {

namespace {

/// Of the file's name; empty: none that is known, which is said where it is to be written.
std::string format_of(const std::string& path) {
    const auto output = OIIO::ImageOutput::create(path);
    OIIO::geterror();
    return output ? output->format_name() : "";
}

class ResizeCommand final : public Command {
public:
    ResizeCommand() {
        name = "resize";
        summary = "Resize an image, a sequence, or a part of an image";
        paragraphs = {
            "The same pixels as oiiotool IN --resize:filter=ddt SIZE -o OUT with the plugin; of "
            "ddt-sharp and 8 or 16 bits that OUT keeps those of oiiotool --native. Channels keep "
            "their types, and images their tiles, where OUT's format has them. A --type that OUT "
            "cannot have, such as half in PNG, and a --compression that its format has, but not "
            "for these pixels, such as jpeg in a TIFF of others than RGB of 8 bits, is said on "
            "standard error, with what is written in its place. A --compression that the format "
            "does not have is refused.",
            "Sizes are written as oiiotool's, but not by corners: 640x480; 0x480 keeps the shape; "
            "640x480+10-20 moves the origin; 50%, 50%x75%; 2.5 is a factor. They are those of the "
            "display window.",
            "Sequences: IN and OUT with # (four digits), ### (three) or %04d in place of the "
            "frame's number, in the last part of a path, and, with --views, %V or %v in place of "
            "the view or its first letter, in folders too. Without --frames the frames are those "
            "of which there is a file.",
            "Of a file with several images the first is resized; with --all-images each is, to "
            "SIZE of its own, where OUT's format has room for several (EXR's parts, TIFF's pages).",
            "OUT appears under its name when it is whole; until then what was there stays there."};
        operands = {{"IN", "any image OpenImageIO reads"},
                    {"SIZE", "size of the result"},
                    {"OUT", "any image OpenImageIO writes"}};
        flags = {
            filter_flag("the filter's name and options (default: ddt): ddt-sharp,light=encoded",
                        m_settings.options, m_filter_error),
            choice_flag("--type", {"uint8", "uint16", "half", "float"},
                        "pixel type of the result (default: the image's)", m_settings.type),
            text_flag("--compression", "NAME",
                      "how OUT is compressed: none, zip, dwaa:45 (default: as the image was)",
                      m_settings.compression),
            threads_flag(m_threads),
            text_flag("--frames", "LIST", "frames of a sequence: 1-100, 1-100x2, -5--1, 1,4,9",
                      m_frames),
            text_flag("--views", "LIST", "views of a sequence: left,right", m_views),
            whole_flag("--jobs", "N",
                       "frames at a time (default: 1), fewer where memory would not do", 1, 64,
                       m_run.jobs),
            switch_flag("--all-images", "resize all images of a file, not its first alone",
                        m_settings.all_images),
            switch_flag("--skip-existing",
                        "leave out what is there already (of parts: of the same result)",
                        m_run.skip_existing),
            switch_flag("--keep-going", "go on with the other frames after one failed",
                        m_run.keep_going),
            {"--part", "K/N",
             format("write the part K of N, up to {}, into OUT, an EXR file, for ddt join",
                    most_parts),
             [this](const std::string& text) { return parse_part(text, m_part); }, allowed_parts,
             ""},
            progress_flag(m_progress),
        };
    }

    ExitCode run(const std::vector<std::string>& values) override {
        if (!m_filter_error.empty())
            return fail(m_filter_error, exit_usage);
        if (m_settings.all_images && m_part.count > 0)
            return fail("--part is of a file's first image; leave out --all-images", exit_usage);
        m_settings.size = values[1];
        std::vector<FrameTask> tasks{{values[0], values[2]}};
        Failure failure;
        const bool sequence = is_sequence(values[0], m_frames, m_views);
        if (sequence && !list_tasks(values[0], values[2], m_frames, m_views, tasks, failure))
            return fail(failure);
        if (!is_size(values[1])) // of any frame
            return fail(wrong_size(values[1]), exit_usage);
        if (!m_settings.compression.empty() &&
            !check_compression(m_settings.compression,
                               m_part.count > 0 ? "" : format_of(tasks.front().out), failure.why))
            return fail(failure.why, exit_usage);

        m_settings.threads = share_threads(m_threads);
        m_run.run = [this](const FrameTask& task, const ProgressCallback& progress, Failure& why) {
            const bool done =
                m_part.count > 0 ? resize_part(task.in, task.out, m_settings, m_part, progress, why)
                                 : resize_file(task.in, task.out, m_settings, progress, why);
            if (!done && why.code == exit_failed)
                why.code = code_of_reading(task.in);
            return done;
        };
        if (m_part.count > 0)
            m_run.is_made = [this](const FrameTask& task) {
                return is_part_there(task.in, task.out, m_settings, m_part);
            };
        m_run.memory_of = [this](const FrameTask& task) {
            return m_run.jobs > 1 ? memory_to_resize(task.in, task.out, m_settings) : 0;
        };
        FrameCounts counts;
        {
            Progress progress(sequence ? std::to_string(tasks.size()) + " frames" : "resizing",
                              progress_mode(m_progress));
            counts = run_frames(tasks, m_run, progress);
        }
        if (sequence)
            tell(format("{} frames: {} written, {} skipped, {} failed", tasks.size(),
                        counts.written, counts.skipped, counts.failed));
        return counts.code;
    }

private:
    ResizeSettings m_settings;
    int m_threads = 0; ///< 0: all
    FrameRun m_run;
    Part m_part{0, 0}; ///< no part
    std::string m_filter_error, m_frames, m_views, m_progress = "auto";
};

} // namespace

std::unique_ptr<Command> make_resize_command() {
    return std::make_unique<ResizeCommand>();
}

} // namespace ddt::tool
