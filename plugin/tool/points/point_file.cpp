// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/point_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <unistd.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "plugin/message/format.h"
#include "plugin/tool/file/file_state.h"

namespace ddt::tool {

namespace {

/// Whether a file is a device that has no end, as far as one can tell: one that is no terminal.
bool is_endless(const std::string& path) {
    if (std::error_code ignored; !std::filesystem::is_character_file(path, ignored))
        return false;
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    const bool endless = descriptor >= 0 && !isatty(descriptor);
    if (descriptor >= 0)
        close(descriptor);
    return endless;
}

/// The bytes of a file. False with errno if they cannot be read.
bool read_bytes(const std::string& path, std::string& bytes) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    try {
        bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    } catch (const std::ios_base::failure&) { // a folder: whatever the stream was asked for
        return false;
    }
    return file.good() || file.eof();
}

} // namespace

std::optional<double> number_in(const std::string& word) {
    char* end = nullptr;
    const double number = word.empty() ? 0 : OIIO::Strutil::strtod(word.c_str(), &end);
    if (word.empty() || end != word.c_str() + word.size())
        return {};
    return number;
}

const Column* PointFile::find(const std::string& name) const {
    for (const Column& column : columns)
        if (column.name == name)
            return &column;
    return nullptr;
}

const Column* PointFile::find_meant(const std::string& name) const {
    if (const Column* column = find(name))
        return column;
    for (const Column& column : columns)
        if (OIIO::Strutil::iequals(column.name, name))
            return &column;
    for (const auto& [colour, letter] : colour_columns)
        if (OIIO::Strutil::iequals(name, letter))
            return find(colour);
    return nullptr;
}

namespace {

bool read_once(const std::string& path, PointFile& points, Failure& failure) {
    if (is_endless(path)) {
        failure = {"\"" + path + "\": it is a device; allowed are files, pipes and terminals"};
        return false;
    }
    std::string text;
    if (!read_bytes(path, text)) {
        const int number = errno ? errno : EIO;
        failure = {"\"" + path + "\": " + std::strerror(number), code_of_errno(number)};
        return false;
    }
    const std::string extension = OIIO::Strutil::lower(OIIO::Filesystem::extension(path));
    std::string error;
    const bool ply = extension == ".ply" || text.compare(0, 4, "ply\n") == 0 ||
                     text.compare(0, 5, "ply\r\n") == 0;
    if (ply ? read_ply(text, points, error) : read_table(text, points, error))
        return true;
    failure = {"\"" + path + "\": " + error, exit_failed};
    return false;
}

} // namespace

bool read_points(const std::string& path, PointFile& points, Failure& failure) {
    const FileState before(path);
    return before.confirm(read_once(path, points, failure), failure);
}

std::string fault_in(const std::string& path, const PointFile& points, const std::string& why) {
    const auto begins = [&](const char* text) { return OIIO::Strutil::starts_with(why, text); };
    if (!begins("ddt: triangle") && !begins("ddt: the points"))
        return why;
    unsigned long triangle = 0;
    int end = 0;
    const std::string name = "\"" + path + "\": ";
    if (std::sscanf(why.c_str(), "ddt: triangle %lu%n", &triangle, &end) == 1 &&
        triangle < points.faces.size())
        return name + format("face {}", points.faces[triangle]) + why.substr(size_t(end));
    return name + why.substr(std::strlen("ddt: "));
}

} // namespace ddt::tool
