// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

#include "child.h"
#include "plugin/message/format.h"
#include "rows.h"

namespace bench {

namespace {

// Raw big-endian samples without a header: there is no colour space that ImageMagick could think
// of and convert from.
bool write_raw(const OIIO::ImageBuf& image, const std::string& path) {
    std::vector<float> values(image.spec().image_pixels() * 3);
    image.get_pixels(image.roi(), OIIO::TypeDesc::FLOAT, values.data());
    std::vector<char> bytes;
    bytes.reserve(values.size() * 2);
    for (float value : values) {
        auto sample = uint16_t(std::lround(std::clamp(value, 0.0f, 1.0f) * 65535));
        bytes.push_back(char(sample >> 8));
        bytes.push_back(char(sample & 255));
    }
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    return bool(file);
}

bool read_raw(OIIO::ImageBuf& image, const std::string& path) {
    std::vector<float> values(image.spec().image_pixels() * 3);
    std::vector<unsigned char> bytes(values.size() * 2);
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!file)
        return false;
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = float(bytes[2 * i] * 256 + bytes[2 * i + 1]) / 65535.0f;
    return image.set_pixels(image.roi(), OIIO::TypeDesc::FLOAT, values.data());
}

std::string size_of(const OIIO::ImageSpec& spec) {
    return std::to_string(spec.width) + "x" + std::to_string(spec.height);
}

OIIO::ImageBuf enlarge(const std::string& program, const std::vector<std::string>& operation,
                       const OIIO::ImageBuf& image, int scale) {
    OIIO::ImageSpec spec = image.spec();
    spec.width *= scale;
    spec.height *= scale;
    spec.full_width = spec.width;
    spec.full_height = spec.height;
    OIIO::ImageBuf result(spec);

    ScratchFolder folder;
    const std::string in = folder.file("in.rgb"), out = folder.file("out.rgb");
    std::vector<std::string> command = {
        program, "-size", size_of(image.spec()), "-depth", "16", "-endian", "MSB", "rgb:" + in};
    command.insert(command.end(), operation.begin(), operation.end());
    command.insert(command.end(),
                   {size_of(spec) + "!", "-depth", "16", "-endian", "MSB", "rgb:" + out});
    if (!write_raw(image, in) || run_child(command) != 0 || !read_raw(result, out))
        ddt::set_error(result, program + " failed");
    return result;
}

/// "magick" from version 7 on, "convert" before; empty if neither is there.
std::string find_program() {
    for (const char* program : {"magick", "convert"})
        if (run_child({program, "-size", "1x1", "xc:black", "null:"}) == 0)
            return program;
    return {};
}

} // namespace

std::vector<Row> imagemagick_rows() {
    const std::string program = find_program();
    if (program.empty())
        return {};
    struct Operation {
        const char* name;
        std::vector<std::string> arguments;
    };
    const Operation operations[] = {
        {"IM adaptive-resize", {"-adaptive-resize"}},
        {"IM Lanczos", {"-filter", "Lanczos", "-resize"}},
        {"IM EWA LanczosSharp", {"-filter", "LanczosSharp", "-distort", "Resize"}},
    };
    std::vector<Row> rows;
    for (const Operation& operation : operations)
        rows.push_back({operation.name, [program, arguments = operation.arguments](
                                            const OIIO::ImageBuf& image, int scale) {
                            return enlarge(program, arguments, image, scale);
                        }});
    return rows;
}

} // namespace bench
