// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/stream/stream_frame.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <OpenImageIO/strutil.h>

#include "core/base/parse_number.h"
#include "plugin/image/largest_side.h"
#include "plugin/image/memory.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

constexpr size_t longest_word = 64;

bool is_blank(int c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// A stream that ends where it cannot be read, and knows why.
class Input {
public:
    explicit Input(std::FILE* file) : m_file(file) {}

    /// A byte, or EOF.
    int get() {
        const int c = m_error ? EOF : std::getc(m_file);
        if (c == EOF)
            note_error();
        return c;
    }
    /// How many of so many bytes are there.
    size_t read(char* to, size_t bytes) {
        const size_t n = m_error ? 0 : std::fread(to, 1, bytes, m_file);
        if (n < bytes)
            note_error();
        return n;
    }
    /// The number of the error that it cannot be read for, or 0.
    int error() const { return m_error; }

private:
    /// At once: whatever is called next may set errno, and a read that is tried again may succeed.
    void note_error() {
        if (m_error == 0 && std::ferror(m_file))
            m_error = errno;
    }

    std::FILE* m_file;
    int m_error = 0;
};

/// The next word of a header, and the one blank after it; comments from # to the line's end are
/// skipped. Empty at the end of the stream or for a word of senseless length.
std::string word(Input& in) {
    int c = in.get();
    while (is_blank(c) || c == '#') {
        if (c == '#')
            while (c != '\n' && c != EOF)
                c = in.get();
        else
            c = in.get();
    }
    std::string text;
    for (; c != EOF && !is_blank(c) && text.size() < longest_word; c = in.get())
        text += char(c);
    return text.size() < longest_word ? text : "";
}

constexpr int largest_value = 65535, most_channels = 4;

/// A whole number of a header, called `name` there, from 1 to `most`.
bool read_whole(const char* name, const std::string& text, int most, int& number,
                std::string& error) {
    if (parse_number(text, 1, most, number))
        return true;
    if (text.empty()) {
        error = format("the header ends before its {}", name);
        return false;
    }
    error = format("{} \"{}\" is not allowed in a header; allowed are 1 to {}", name, text, most);
    return false;
}

/// The lines "WIDTH 640" up to "ENDHDR".
bool read_pam(Input& in, Frame& frame, std::string& error) {
    struct Field {
        const char* name;
        int most;
        int& number;
    };
    const Field fields[] = {{"WIDTH", largest_side, frame.width},
                            {"HEIGHT", largest_side, frame.height},
                            {"DEPTH", most_channels, frame.channels},
                            {"MAXVAL", largest_value, frame.largest}};
    for (std::string key = word(in); key != "ENDHDR"; key = word(in)) {
        const auto* field = std::find_if(std::begin(fields), std::end(fields),
                                         [&](const Field& f) { return key == f.name; });
        if (key.empty()) {
            error = "the header ends before ENDHDR";
            return false;
        }
        if (field == std::end(fields) && key != "TUPLTYPE") {
            error = format("\"{}\" is not allowed in the header of a P7 picture", key);
            return false;
        }
        const std::string value = word(in);
        if (field == std::end(fields))
            frame.tuple_type = value;
        else if (!read_whole(field->name, value, field->most, field->number, error))
            return false;
    }
    for (const Field& field : fields)
        if (field.number == 0) {
            error = format("there is no {} in the header of a P7 picture", field.name);
            return false;
        }
    return true;
}

bool read_header(Input& in, Frame& frame, std::string& error) {
    if (frame.magic == "P7")
        return read_pam(in, frame, error);
    frame.channels = frame.magic == "P6" || frame.magic == "PF" ? 3 : 1;
    if (!read_whole("width", word(in), largest_side, frame.width, error) ||
        !read_whole("height", word(in), largest_side, frame.height, error))
        return false;
    if (frame.magic[1] == '5' || frame.magic[1] == '6')
        return read_whole("largest value", word(in), largest_value, frame.largest, error);
    frame.scale = word(in);
    char* end = nullptr;
    const double scale = OIIO::Strutil::strtod(frame.scale.c_str(), &end);
    if (!frame.scale.empty() && *end == 0 && std::isfinite(scale) && scale != 0)
        return true;
    error = format("scale \"{}\" is not allowed in a header; allowed are finite numbers but 0",
                   frame.scale);
    return false;
}

std::string header(const Frame& f) {
    const std::string size = std::to_string(f.width) + " " + std::to_string(f.height) + "\n";
    if (f.is_float())
        return f.magic + "\n" + size + f.scale + "\n";
    const std::string largest = std::to_string(f.largest) + "\n";
    if (f.magic != "P7")
        return f.magic + "\n" + size + largest;
    return "P7\nWIDTH " + std::to_string(f.width) + "\nHEIGHT " + std::to_string(f.height) +
           "\nDEPTH " + std::to_string(f.channels) + "\nMAXVAL " + largest +
           (f.tuple_type.empty() ? "" : "TUPLTYPE " + f.tuple_type + "\n") + "ENDHDR\n";
}

/// From the stream's order of bytes to this machine's, or back.
void order_bytes(Frame& f) {
    constexpr uint16_t one = 1;
    const bool low_first_here = *reinterpret_cast<const char*>(&one) == 1;
    const bool low_first = f.is_float() && f.scale[0] == '-';
    const size_t size = host::size_of(f.sample());
    if (size > 1 && low_first != low_first_here)
        for (size_t i = 0; i < f.bytes(); i += size)
            std::reverse(&f.pixels[i], &f.pixels[i] + size);
}

/// Values of another largest one, as those of 1 bit or 10, become such of 16 bits.
void widen(Frame& f) {
    const size_t size = host::size_of(f.sample()), count = f.bytes() / size;
    std::unique_ptr<char[]> wide(new char[count * sizeof(uint16_t)]);
    for (size_t i = 0; i < count; ++i) {
        uint16_t value = uint8_t(f.pixels[i * size]);
        if (size > 1)
            std::memcpy(&value, &f.pixels[i * size], size);
        const auto largest = uint32_t(f.largest);
        value =
            uint16_t((std::min(uint32_t(value), largest) * largest_value + largest / 2) / largest);
        std::memcpy(&wide[i * sizeof value], &value, sizeof value);
    }
    f.pixels = std::move(wide);
    f.largest = largest_value;
    const std::string black_and_white = "BLACKANDWHITE";
    if (f.tuple_type.compare(0, black_and_white.size(), black_and_white) == 0)
        f.tuple_type.replace(0, black_and_white.size(), "GRAYSCALE");
}

/// The row of the memory that is the stream's i-th: PFM's run upwards.
char* row(Frame& f, int i) {
    const int y = f.is_float() ? f.height - 1 - i : i;
    return f.pixels.get() + size_t(y) * f.row_bytes();
}

bool read_rows(Input& in, Frame& frame, std::string& error) {
    size_t got = 0;
    for (int i = 0; i < frame.height; ++i) {
        const size_t n = in.read(row(frame, i), frame.row_bytes());
        got += n;
        if (n < frame.row_bytes()) {
            error = "it ends after " + std::to_string(got) + " of " +
                    std::to_string(frame.bytes()) + " bytes";
            return false;
        }
    }
    return true;
}

/// What follows the two letters that a picture begins with.
bool read_rest(Input& in, Frame& frame, std::string& error) {
    if (frame.magic != "P7" && frame.magic != "P6" && frame.magic != "P5" && frame.magic != "PF" &&
        frame.magic != "Pf") {
        error = "no picture begins here; allowed are PAM (P7), PPM (P6), PGM (P5) and PFM";
        return false;
    }
    if (!read_header(in, frame, error))
        return false;
    if (frame.tuple_type.compare(0, 4, "CMYK") == 0) {
        error = "the tuple type " + frame.tuple_type +
                " is not allowed; allowed are grey and RGB, with alpha or without";
        return false;
    }
    return frame.allocate(error) && read_rows(in, frame, error);
}

} // namespace

host::Sample Frame::sample() const {
    return is_float()      ? host::Sample::float32
           : largest < 256 ? host::Sample::uint8
                           : host::Sample::uint16;
}

size_t Frame::row_bytes() const {
    return size_t(width) * size_t(channels) * host::size_of(sample());
}

bool Frame::allocate(std::string& error) {
    const OIIO::TypeDesc type = is_float()      ? OIIO::TypeFloat
                                : largest < 256 ? OIIO::TypeUInt8
                                                : OIIO::TypeUInt16;
    if (!check_size({0, width, 0, height, 0, 1, 0, channels}, channels, type, error))
        return false;
    pixels.reset(new char[bytes()]);
    return true;
}

Frame Frame::of_size(int new_width, int new_height) const {
    Frame other;
    static_cast<FrameHeader&>(other) = *this;
    other.width = new_width;
    other.height = new_height;
    return other;
}

host::Buffer Frame::buffer() {
    const auto size = ptrdiff_t(host::size_of(sample()));
    return {pixels.get(), ptrdiff_t(row_bytes()), size * channels,
            size,         {0, 0, width, height},  sample()};
}

ReadResult read_frame(std::FILE* file, Frame& frame, Failure& failure) {
    frame = {};
    Input in(file);
    const int first = in.get();
    if (first == EOF && in.error() == 0)
        return ReadResult::end;
    frame.magic = {char(first), char(in.get())};
    if (!read_rest(in, frame, failure.why)) {
        // Where the stream cannot be read the header, or the pixels, seem to end.
        failure =
            in.error()
                ? Failure{std::string("the stream cannot be read: ") + std::strerror(in.error()),
                          code_of_errno(in.error())}
                : Failure{failure.why, code_of_message(failure.why)};
        return ReadResult::failed;
    }
    order_bytes(frame);
    if (!frame.is_float() && frame.largest != 255 && frame.largest != largest_value)
        widen(frame);
    return ReadResult::frame;
}

bool write_frame(std::FILE* out, Frame& frame, std::string& error) {
    order_bytes(frame);
    const std::string text = header(frame);
    bool done = std::fwrite(text.data(), 1, text.size(), out) == text.size();
    for (int i = 0; done && i < frame.height; ++i)
        done = std::fwrite(row(frame, i), 1, frame.row_bytes(), out) == frame.row_bytes();
    if (done && std::fflush(out) == 0)
        return true;
    error = errno == EPIPE ? "the reader of the result has gone"
                           : std::string("the result cannot be written: ") + std::strerror(errno);
    return false;
}

} // namespace ddt::tool
