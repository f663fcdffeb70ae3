// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/sequence/sequence.h"

#include <filesystem>
#include <map>
#include <set>

#include <OpenImageIO/strutil.h>

#include "plugin/tool/file/whole_file.h"
#include "plugin/tool/sequence/frames.h"

namespace ddt::tool {

namespace {

namespace fs = std::filesystem;

bool refuse(const std::string& why, Failure& failure) {
    failure = {why, exit_usage};
    return false;
}

/// The names between commas, without blanks about them; none of an empty text. False if one is
/// empty: of left,,right the files of no view would be looked for.
bool parse_views(const std::string& text, std::vector<std::string>& names) {
    if (text.empty())
        return true;
    for (const std::string& item : OIIO::Strutil::splits(text, ",")) {
        names.emplace_back(OIIO::Strutil::strip(item));
        if (names.back().empty())
            return false;
    }
    return true;
}

/// Whether a name leaves open what is given, and nothing else.
bool check_name(const std::string& text, const FrameName& name, bool frames, bool views,
                Failure& failure) {
    if (name.has_frame() != frames)
        return refuse("\"" + text + "\" " +
                          (frames
                               ? "has no place for the frame in its last part, the "
                                 "file's name; allowed are names such as in.#.exr and in.%04d.exr"
                               : "needs frames; give --frames, or an input with them"),
                      failure);
    if (name.has_view() != views)
        return refuse("\"" + text + "\" " +
                          (views ? "has no place for the view; allowed are names with %V or %v"
                                 : "needs views; give --views"),
                      failure);
    return true;
}

/// Names by which files are told apart: without links, which lead to one file, or one folder, from
/// many names. (What leads to a device is no file: many may.)
class Names {
public:
    std::string of(const std::string& path) {
        fs::path name = followed(path);
        std::error_code ignored;
        if (name != path && fs::is_other(name, ignored))
            name = path;
        const auto [known, is_new] = m_folders.try_emplace(name.parent_path().string());
        if (is_new) // folders are looked at once: a file system on a network takes its time
            known->second = whole(name.parent_path());
        return (known->second / name.filename()).string();
    }

private:
    /// Also of a folder that is not there yet.
    static fs::path whole(const fs::path& folder) {
        std::error_code error;
        const fs::path absolute = fs::absolute(folder.empty() ? "." : folder, error);
        const fs::path canonical = fs::weakly_canonical(absolute, error);
        return error ? absolute.lexically_normal() : canonical;
    }

    std::map<std::string, fs::path> m_folders;
};

/// Whether no file would be written from two, "left" and "lower" have one first letter, and none is
/// another's source.
bool check_outputs(const std::vector<FrameTask>& tasks, Failure& failure) {
    std::map<std::string, std::string> source;
    std::vector<std::string> sources; // one a task
    Names names;
    for (const FrameTask& task : tasks)
        sources.push_back(names.of(task.in));
    const std::set<std::string> all_sources(sources.begin(), sources.end());
    for (size_t i = 0; i < tasks.size(); ++i) {
        const FrameTask& task = tasks[i];
        const std::string out = names.of(task.out);
        if (out != sources[i] && all_sources.count(out) > 0)
            return refuse("\"" + task.in + "\" would become \"" + task.out +
                              "\", which is another's source",
                          failure);
        const auto [other, first] = source.try_emplace(out, task.in);
        if (!first && other->second != task.in)
            return refuse("\"" + other->second + "\" and \"" + task.in + "\" would both become \"" +
                              task.out + "\"",
                          failure);
    }
    return true;
}

/// Whether one of the folders has a # in its name and is not there: it was meant for a frame's
/// number. Of folders that have views, and of those in them, it cannot be told: before the views'
/// names are put in, none is there. Nor can it of one that cannot be looked at.
bool is_numbered_folder(const std::string& in) {
    fs::path folder;
    for (const fs::path& part : fs::path(in).parent_path()) {
        const std::string name = part.string();
        if (FrameName(name).has_view())
            return false;
        folder /= part;
        std::error_code ignored;
        if (name.find('#') != std::string::npos &&
            fs::status(folder, ignored).type() == fs::file_type::not_found)
            return true;
    }
    return false;
}

} // namespace

bool is_sequence(const std::string& in, const std::string& frames, const std::string& views) {
    const FrameName name(in);
    std::error_code ignored;
    return !frames.empty() || !views.empty() || is_numbered_folder(in) ||
           ((name.has_frame() || name.has_view()) && !fs::exists(in, ignored));
}

bool list_tasks(const std::string& in, const std::string& out, const std::string& frames,
                const std::string& views, std::vector<FrameTask>& tasks, Failure& failure) {
    const FrameName from(in), to(out);
    const bool in_folder = is_numbered_folder(in);
    const bool numbered = !frames.empty() || from.has_frame() || in_folder;
    const bool is_right = check_name(in, from, numbered, !views.empty(), failure);
    if (!is_right || !check_name(out, to, numbered, !views.empty(), failure)) {
        // It may have been meant as a name like any other, such as photo@2x.png.
        if (frames.empty() && views.empty() && (is_right || in_folder))
            failure.why = "there is no file \"" + in + "\"; of its frames, " + failure.why;
        return false;
    }
    std::vector<std::string> names;
    if (!parse_views(views, names))
        return refuse("--views \"" + views +
                          "\" is not allowed; allowed are names after commas, none of them empty: "
                          "left,right",
                      failure);
    std::vector<int> numbers{0};
    if (!frames.empty() && !parse_frames(frames, numbers))
        return refuse("--frames \"" + frames + "\" is not allowed; allowed are " + allowed_frames,
                      failure);
    if (frames.empty() && numbered && !from.frames_there(names, numbers, failure))
        return false;
    if (numbers.empty()) {
        failure = {"there is no file \"" + in + "\" of any frame"};
        return false;
    }
    tasks.clear();
    for (const int number : numbers)
        for (const std::string& view : names.empty() ? std::vector<std::string>{""} : names)
            tasks.push_back({from.name(number, view), to.name(number, view)});
    return check_outputs(tasks, failure);
}

} // namespace ddt::tool
