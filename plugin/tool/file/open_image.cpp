// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/open_image.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "plugin/image/lazy_file.h"
#include "plugin/image/oiio_defects.h"
#include "plugin/message/format.h"
#include "plugin/tool/file/file_state.h"
#include "plugin/tool/file/readable_pixels.h"
#include "plugin/tool/file/reading_errors.h"
#include "plugin/tool/file/truncated.h"

namespace ddt::tool {

namespace {

/// A text without lines that it has twice but for their numbers: OpenImageIO 3 says again what it
/// said before, and TIFF's reader the same of one strip after the other.
std::string each_line_once(const std::string& text) {
    std::vector<std::string> lines, known;
    for (const std::string& line : OIIO::Strutil::splits(text, "\n")) {
        std::string words;
        std::copy_if(line.begin(), line.end(), std::back_inserter(words),
                     [](char c) { return c < '0' || c > '9'; });
        if (line.empty() || std::find(known.begin(), known.end(), words) != known.end())
            continue;
        lines.push_back(line);
        known.push_back(words);
    }
    return OIIO::Strutil::join(lines, "\n");
}

std::string cannot_read(const std::string& path, const std::string& why) {
    return "cannot read \"" + path + "\": " + why;
}

/// False with one line in `error` if a file of a format is cut off.
bool check_whole(const std::string& path, const std::string& format, int number,
                 std::string& error) {
    if (!is_truncated(path, format, number))
        return true;
    error = cannot_read(path, "the file ends before its pixels do");
    return false;
}

/// What a file is of which readers would never be done, or null: a pipe they open again and again,
/// and some devices (/dev/zero) have no end.
const char* endless_kind(const std::string& path) {
    std::error_code ignored;
    switch (std::filesystem::status(path, ignored).type()) {
    case std::filesystem::file_type::fifo:
        return "a pipe";
    case std::filesystem::file_type::character:
        return "a device";
    default:
        return nullptr;
    }
}

/// False with one line in `error` if the pixels of a file cannot be read.
bool check_pixels(const std::string& path, int number, const OIIO::ImageSpec* hints,
                  std::string& error) {
    const auto input = open_input(path, number, error, hints);
    if (!input)
        return false;
    if (can_be_read(*input))
        return true;
    error = why_unreadable(input->geterror(), path);
    return false;
}

bool read_image(const std::string& path, OIIO::ImageBuf& image, std::string& error, int number,
                const OIIO::ImageSpec* hints) {
    if (!check_reader(path, number, error))
        return false;
    image.reset(path, number, 0, nullptr, hints);
    if (!begin_image(path, number, image, error))
        return false;
    if (!hints && is_pfm(std::string(image.file_format_name()), image.nativespec())) {
        const OIIO::ImageSpec none; // without any it is upside down
        return read_image(path, image, error, number, &none);
    }
    if (may_pass_over(std::string(image.file_format_name()), image.nativespec()) &&
        !check_pixels(path, number, hints, error))
        return false;
    const bool floats = is_associated_when_read(image.nativespec());
    if (image.read(number, 0, true, floats ? OIIO::TypeFloat : OIIO::TypeUnknown))
        return true;
    error = why_unreadable(image, path);
    return false;
}

} // namespace

std::string why_unreadable(const OIIO::ImageBuf& image, const std::string& path) {
    return why_unreadable(image.has_error() ? image.geterror() : "", path);
}

std::string why_unreadable(const std::string& said, const std::string& path) {
    if (const std::string why = why_not_opened(path); !why.empty())
        return cannot_read(path, why);
    // Some readers call it broken. A name with a query need not be a file's.
    if (path.find('?') == std::string::npos && !OIIO::Filesystem::exists(path))
        return cannot_read(path, std::strerror(ENOENT));
    const std::string why = said.empty() ? "cannot read \"" + path + "\"" : each_line_once(said);
    return why.find(path) == std::string::npos ? "\"" + path + "\": " + why : why;
}

std::string image_name(const std::string& path, int number) {
    const std::string name = "\"" + path + "\"";
    return number > 0 ? format("{}, image {}", name, number + 1) : name;
}

bool check_reader(const std::string& path, int number, std::string& error) {
    if (const char* kind = endless_kind(path)) {
        error = cannot_read(path, format("it is {}, and images are read from files alone", kind));
        return false;
    }
    char begin[2] = {};
    std::ifstream(path, std::ios::binary).read(begin, sizeof begin);
    if (begin[0] != begin[1] || (begin[0] != 'I' && begin[0] != 'M')) // no TIFF
        return true;
    const auto input = OIIO::ImageInput::open(path);
    OIIO::geterror();
    if (!input || !overruns_memory(input->spec(number)))
        return true;
    error = cannot_read(path, why_overrun);
    return false;
}

bool check_reader(const std::string& path, int number, Failure& failure) {
    if (check_reader(path, number, failure.why))
        return true;
    failure.code = code_of_message(failure.why);
    return false;
}

bool begin_image(const std::string& path, int number, OIIO::ImageBuf& image, std::string& error) {
    if (image.init_spec(path, number, 0))
        return check_whole(path, std::string(image.file_format_name()), number, error);
    error = why_unreadable(image, path);
    return false;
}

bool open_image(const std::string& path, OIIO::ImageBuf& image, std::string& error, int number,
                const OIIO::ImageSpec* hints) {
    if (path.empty()) { // OpenImageIO makes an image of it that is not there
        error = "\"\" is no name of a file";
        return false;
    }
    const FileState before(path);
    const bool read = read_image(path, image, error, number, hints);
    if (before.is_of_one_file(read))
        return read;
    error = why_changed(path);
    return false;
}

std::unique_ptr<OIIO::ImageInput> open_input(const std::string& path, int number,
                                             std::string& error, const OIIO::ImageSpec* hints) {
    auto input = OIIO::ImageInput::open(path, hints);
    if (!input)
        error = why_unreadable(OIIO::geterror(), path);
    else if (!hints && !turn_rows_of_pfm(path, *input)) {
        error = why_unreadable(input->geterror(), path);
        input.reset();
    } else if (number > 0 && !input->seek_subimage(number, 0)) {
        error = why_unreadable(input->geterror(), path);
        input.reset();
    } else if (!check_whole(path, input->format_name(), number, error))
        input.reset();
    else if (overruns_memory(input->spec())) {
        error = cannot_read(path, why_overrun);
        input.reset();
    }
    if (input)
        wait_for_tiles(*input);
    return input;
}

OIIO::ImageSpec spec_of_file(const OIIO::ImageBuf& image) {
    OIIO::ImageSpec spec = image.spec();
    spec.set_format(image.nativespec().format);
    spec.channelformats = image.nativespec().channelformats;
    spec.tile_width = image.nativespec().tile_width;
    spec.tile_height = image.nativespec().tile_height;
    spec.tile_depth = image.nativespec().tile_depth;
    return spec;
}

Failure unreadable(const std::string& path, const std::string& error) {
    const ExitCode code = code_of_message(error);
    return {error, code == exit_failed ? code_of_reading(path) : code};
}

} // namespace ddt::tool
