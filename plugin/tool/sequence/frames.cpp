// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/sequence/frames.h"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <system_error>

namespace ddt::tool {

namespace {

constexpr size_t most_frames = 1000000;

bool number(const std::string& text, int& n) {
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), n);
    return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
}

/// One of the items between commas, without them.
bool append_range(const std::string& item, std::vector<int>& frames) {
    static const std::regex form("(-?[0-9]+)(?:-(-?[0-9]+)(?:x([0-9]+))?)?");
    constexpr size_t longest = 40; // std::regex calls itself for each character
    std::smatch part;
    int first = 0, last = 0, by = 1;
    if (item.size() > longest || !std::regex_match(item, part, form) || !number(part[1], first))
        return false;
    last = first;
    if ((part[2].matched && !number(part[2], last)) || (part[3].matched && !number(part[3], by)) ||
        by < 1)
        return false;
    // The distance between two ints may be more than an int holds.
    const int64_t step = last < first ? -int64_t(by) : by;
    const size_t count = size_t((int64_t(last) - first) / step) + 1;
    if (frames.size() + count > most_frames)
        return false;
    for (size_t i = 0; i < count; ++i)
        frames.push_back(int(first + int64_t(i) * step));
    return true;
}

void replace(std::string& text, const char* what, const std::string& by) {
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, 2, by);
}

/// A path without its folder.
std::string name_of(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

/// The names of a folder's files; none of one that is not there.
bool list_folder(const std::string& folder, std::vector<std::string>& names, Failure& failure) {
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) // where it fails it becomes the end
        names.push_back(at->path().filename().string());
    if (!error || error == std::errc::no_such_file_or_directory ||
        error == std::errc::not_a_directory)
        return true;
    failure = {"cannot read folder \"" + folder + "\": " + error.message(),
               code_of_errno(error.value())};
    return false;
}

/// Where the number stands: the last "%04d", or else the last "####", or else "@@@@". The others
/// may be of the name itself, as in "sky@2x.%04d.png" or "take#3.####.exr".
bool find_place(const std::string& name, std::smatch& place) {
    static const std::regex forms[] = {std::regex("%(0([1-9]))?d"), std::regex("#+"),
                                       std::regex("@+")};
    for (const std::regex& form : forms) {
        for (std::sregex_iterator at(name.begin(), name.end(), form), end; at != end; ++at)
            place = *at;
        if (!place.empty())
            return true;
    }
    return false;
}

} // namespace

bool parse_frames(const std::string& text, std::vector<int>& frames) {
    std::vector<int> listed;
    size_t begin = 0;
    for (size_t end = 0; end != std::string::npos; begin = end + 1) {
        end = text.find(',', begin);
        if (!append_range(text.substr(begin, end - begin), listed))
            return false;
    }
    std::set<int> met;
    listed.erase(std::remove_if(listed.begin(), listed.end(),
                                [&](int frame) { return !met.insert(frame).second; }),
                 listed.end());
    frames = listed;
    return true;
}

FrameName::FrameName(const std::string& text) : m_before(text) {
    const std::string name = name_of(text);
    m_has_view = text.find("%V") != std::string::npos || text.find("%v") != std::string::npos;
    std::smatch part;
    // No file has a longer name; std::regex calls itself for each character.
    if (name.size() > NAME_MAX || !find_place(name, part))
        return;
    const std::string number = part[0];
    m_digits = number == "#"      ? 4
               : number[0] == '%' ? (part[2].matched ? std::atoi(part[2].str().c_str()) : 1)
                                  : int(number.size());
    m_before = text.substr(0, text.size() - name.size()) + name.substr(0, size_t(part.position()));
    m_after = part.suffix();
}

std::string FrameName::name(int frame, const std::string& view) const {
    std::string text = m_before;
    if (has_frame()) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%0*d", std::min(m_digits, 16), frame);
        text += digits + m_after;
    }
    if (m_has_view) {
        replace(text, "%V", view);
        replace(text, "%v", view.substr(0, 1));
    }
    return text;
}

bool FrameName::frames_there(const std::vector<std::string>& views, std::vector<int>& frames,
                             Failure& failure) const {
    std::set<int> found;
    frames.clear();
    if (!has_frame())
        return true;
    for (const std::string& view : views.empty() ? std::vector<std::string>{""} : views) {
        // Where the number would begin; what comes after it is checked by making the name.
        FrameName before = *this;
        before.m_digits = -1;
        const std::string path = before.name(0, view), prefix = name_of(path);
        const std::string folder = path.substr(0, path.size() - prefix.size());
        std::vector<std::string> names;
        if (!list_folder(folder.empty() ? "." : folder, names, failure))
            return false;
        for (const std::string& found_name : names) {
            if (found_name.compare(0, prefix.size(), prefix) != 0)
                continue;
            // What follows may begin with a digit.
            const size_t digits = found_name.find_first_not_of("0123456789-", prefix.size());
            const size_t most = std::min(digits, found_name.size()) - prefix.size();
            for (size_t n = 1; n <= most; ++n) {
                int frame = 0;
                if (number(found_name.substr(prefix.size(), n), frame) &&
                    name_of(name(frame, view)) == found_name)
                    found.insert(frame);
            }
        }
    }
    frames.assign(found.begin(), found.end());
    return true;
}

} // namespace ddt::tool
