// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/picture.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "core/guide/guide.h"
#include "plugin/image/file_tiles.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/memory.h"
#include "plugin/image/oiio_defects.h"
#include "plugin/image/source.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"
#include "plugin/tool/file/file_state.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/truncated.h"

namespace ddt::tool {

namespace {

/// Whether there is nothing that can be looked at: numbers that name things, at most with alpha.
bool only_ids(const Channels& channels) {
    return channels.colour.count == 0 && channels.guide.empty() &&
           std::count(channels.kinds.begin(), channels.kinds.end(), Channel::nearest) > 0;
}

/// How a pixel's values become a Colour.
class Display {
public:
    explicit Display(const Reading& reading)
        : m_layout(shown_colour(reading.channels)), m_linear(reading.guide.linear),
          m_alpha(reading.channels.alpha) {}
    Colour operator()(const float* pixel) const {
        const float alpha = m_alpha >= 0 ? pixel[m_alpha] : 1.0f;
        const bool divide = m_layout.alpha >= 0 && alpha != 0.0f;
        float shown[3];
        for (int k = 0; k < 3; ++k) {
            const int channel = m_layout.channel[m_layout.count == 3 ? k : 0];
            float v = channel >= 0 ? pixel[channel] : 0.0f;
            v = divide ? v / alpha : v;
            shown[k] = m_linear ? srgb_curve(v) : v;
        }
        return {shown[0], shown[1], shown[2], alpha};
    }

private:
    ColourLayout m_layout;
    bool m_linear;
    int m_alpha;
};

/// [begin, end) cut to the file's pixels along an axis and extended to whole tiles.
void to_tiles(int first, int size, int tile, int& begin, int& end) {
    const int side = tile_side(tile, size);
    begin = std::max(begin - first, 0) / side * side;
    end = std::min(rounded_up(std::min(end - first, size), side), size);
    begin += first;
    end += first;
}

/// A text without lines that it has twice: OpenImageIO 3 says again what it said before.
std::string each_line_once(const std::string& text) {
    std::vector<std::string> lines;
    for (const std::string& line : OIIO::Strutil::splits(text, "\n"))
        if (!line.empty() && std::find(lines.begin(), lines.end(), line) == lines.end())
            lines.push_back(line);
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

namespace {

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

} // namespace

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

namespace {

bool read_image(const std::string& path, OIIO::ImageBuf& image, std::string& error, int number,
                const OIIO::ImageSpec* hints) {
    if (!check_reader(path, number, error))
        return false;
    image.reset(path, number, 0, nullptr, hints);
    if (!begin_image(path, number, image, error))
        return false;
    const bool floats = is_associated_when_read(image.nativespec());
    if (image.read(number, 0, true, floats ? OIIO::TypeFloat : OIIO::TypeUnknown))
        return true;
    error = why_unreadable(image, path);
    return false;
}

} // namespace

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
                                             std::string& error) {
    auto input = OIIO::ImageInput::open(path);
    if (!input)
        error = why_unreadable(OIIO::geterror(), path);
    else if (number > 0 && !input->seek_subimage(number, 0)) {
        error = why_unreadable(input->geterror(), path);
        input.reset();
    } else if (!check_whole(path, input->format_name(), number, error))
        input.reset();
    else if (overruns_memory(input->spec())) {
        error = cannot_read(path, why_overrun);
        input.reset();
    }
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

namespace {

// 3.x prints errors that nobody asked for.

/// `look` at a file; nothing where it cannot be opened.
template <class Look>
void look_at(const std::string& path, Look&& look) {
    if (const auto input = OIIO::ImageInput::open(path))
        look(*input);
    else
        OIIO::geterror();
}

/// What the reader says of it, where that is so: a file's own texts may be metadata of that name.
int count_images(OIIO::ImageInput& input) {
    const OIIO::ParamValue* const told =
        input.spec().find_attribute("oiio:subimages", OIIO::TypeInt);
    int images = told ? told->get_int() : 1;
    if (images < 1 || !input.seek_subimage(images - 1, 0))
        images = 1;
    while (input.seek_subimage(images, 0))
        ++images;
    input.geterror();
    return images;
}

void note_levels(OIIO::ImageInput& input, const std::string& path) {
    if (input.seek_subimage(0, 1))
        note(format("\"{}\" has MIP levels; the largest alone was taken", path));
    input.geterror();
}

} // namespace

int count_images(const std::string& path) {
    int images = 0;
    look_at(path, [&](OIIO::ImageInput& input) { images = count_images(input); });
    return images;
}

void note_others(const std::string& path, const std::string& how_to_have_all) {
    look_at(path, [&](OIIO::ImageInput& input) {
        if (const int images = count_images(input); images > 1)
            note(format("\"{}\" has {} images; the first alone was taken{}", path, images,
                        how_to_have_all.empty() ? "" : " (all: " + how_to_have_all + ")"));
        note_levels(input, path);
    });
}

void note_levels(const std::string& path) {
    look_at(path, [&](OIIO::ImageInput& input) { note_levels(input, path); });
}

bool read_picture(const OIIO::ImageBuf& image, const Options& options, Picture& picture,
                  std::string& error) {
    if (image.nchannels() < 1 || image.spec().deep) {
        error = "\"" + std::string(image.name()) + "\" has no flat pixels";
        return false;
    }
    Reading reading;
    if (!plan_reading(image, options, image.roi(), reading, error))
        return false;
    if (only_ids(reading.channels)) {
        error = "\"" + std::string(image.name()) +
                "\" has nothing to look at: its channels are whole numbers that name things";
        return false;
    }
    ImageSource source(image, reading);
    const Rect window = rect_of(image.roi());
    const size_t channels = reading.selected.size();
    std::vector<float> values(window.area() * channels);
    picture.width = window.width();
    picture.height = window.height();
    picture.has_alpha = reading.channels.alpha >= 0;
    picture.guide.resize(window.area());
    if (!source.read(window, values.data(), picture.guide.data())) {
        error = source.error();
        return false;
    }
    const Display display(reading);
    picture.colours.resize(window.area());
    for (size_t i = 0; i < picture.colours.size(); ++i)
        picture.colours[i] = display(&values[i * channels]);
    return true;
}

bool check_size_of(const OIIO::ImageSpec& spec, Failure& failure) {
    if (check_size(OIIO::get_roi(spec), spec.nchannels, spec.format, failure.why))
        return true;
    failure.code = code_of_message(failure.why);
    return false;
}

bool read_native(OIIO::ImageInput& input, const Rect& r, int chbegin, int chend, void* to) {
    const OIIO::ImageSpec& spec = input.spec();
    const int number = input.current_subimage();
    return spec.tile_width > 0 ? input.read_tiles(number, 0, r.x0, r.x1, r.y0, r.y1, spec.z,
                                                  spec.z + 1, chbegin, chend, OIIO::TypeUnknown, to)
                               : input.read_scanlines(number, 0, r.y0, r.y1, spec.z, chbegin, chend,
                                                      OIIO::TypeUnknown, to);
}

bool read_native(OIIO::ImageInput& input, const Rect& r, void* to) {
    return read_native(input, r, 0, input.spec().nchannels, to);
}

Rect readable(const OIIO::ImageSpec& file, const Rect& r) {
    const bool tiled = file.tile_width > 0;
    Rect all = r;
    to_tiles(file.x, file.width, tiled ? file.tile_width : file.width, all.x0, all.x1);
    to_tiles(file.y, file.height, tiled ? file.tile_height : 1, all.y0, all.y1);
    return all;
}

} // namespace ddt::tool
