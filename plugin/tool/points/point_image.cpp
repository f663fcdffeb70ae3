// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/point_image.h"

#include <algorithm>

#include <OpenImageIO/imagebuf.h>

#include "plugin/colour/colour_pixels.h"
#include "plugin/colour/encodings.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"
#include "plugin/tool/file/check_image.h"
#include "plugin/tool/file/fit_format.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/points/window.h"

namespace ddt::tool {

namespace {

/// Whether a column's numbers are as displayed.
bool is_displayed(const Column& column) {
    return column.is_colour() && column.scale != 1;
}

bool is_alpha(const Column* column) {
    return column->is_alpha();
}

std::string channel_name(const Column& column) {
    for (const auto& [name, letter] : colour_columns)
        if (column.name == name)
            return letter;
    return column.name == "z" ? "Z" : column.name;
}

/// Whether readers take what files of that format hold for linear light.
bool is_linear(const std::string& format) {
    return format == "openexr" || format == "hdr";
}

OIIO::ImageSpec spec_of(const PixelGrid& grid, const std::vector<const Column*>& columns) {
    const std::vector<std::string> names = channel_names(columns);
    OIIO::ImageSpec spec(grid.width, grid.height, int(names.size()), OIIO::TypeFloat);
    spec.channelnames = names;
    const auto alpha = std::find_if(columns.begin(), columns.end(), is_alpha);
    spec.alpha_channel = int(alpha - columns.begin());
    return spec;
}

/// What the image's channels are at the points.
std::vector<float> values_of(const std::vector<const Column*>& columns, size_t count,
                             size_t channels, size_t alpha) {
    std::vector<float> values(count * channels, 1.0f);
    for (size_t c = 0; c < columns.size(); ++c)
        for (size_t i = 0; i < count; ++i)
            values[i * channels + c] = float(columns[c]->values[i]);
    for (size_t c = 0; c < columns.size(); ++c)
        for (size_t i = 0; i < count && columns[c]->is_colour(); ++i)
            values[i * channels + c] *= values[i * channels + alpha];
    return values;
}

/// Make linear light of the channels that are as displayed.
void make_linear(const std::vector<const Column*>& columns, const OIIO::ImageSpec& spec,
                 std::vector<float>& pixels) {
    for (size_t c = 0; c < columns.size(); ++c)
        if (is_displayed(*columns[c]))
            to_light(*find_encoding("sRGB"), {1, {int(c), -1, -1}, spec.alpha_channel},
                     pixels.data(), spec.image_pixels(), spec.nchannels);
}

/// Leave the first `kept` numbers of every `channels`.
void keep_first(size_t kept, size_t channels, std::vector<float>& pixels) {
    const size_t count = pixels.size() / channels;
    for (size_t i = 0; i < count && kept < channels; ++i)
        std::copy_n(&pixels[i * channels], kept, &pixels[i * kept]);
    pixels.resize(count * kept);
}

} // namespace

std::vector<std::string> channel_names(const std::vector<const Column*>& columns) {
    std::vector<std::string> names;
    for (const Column* column : columns)
        names.push_back(channel_name(*column));
    if (std::none_of(columns.begin(), columns.end(), is_alpha))
        names.emplace_back("A");
    return names;
}

bool write_point_image(const PointFile& points, const std::vector<const Column*>& columns,
                       const PixelGrid& grid, const std::string& path, Failure& failure) {
    const OIIO::ImageSpec drawn = spec_of(grid, columns);
    ImageFile file;
    if (!check_size_of(drawn, failure) || !file.create(path, failure))
        return false;
    const bool displayed = std::any_of(columns.begin(), columns.end(),
                                       [](const Column* column) { return is_displayed(*column); });
    const bool linear = is_linear(file.output().format_name());
    OIIO::ImageSpec spec = drawn;
    if (displayed && !linear)
        spec.attribute("oiio:ColorSpace", "sRGB");
    if (!fit_format(file.output(), path, spec, failure))
        return false;
    const std::string left_out = fit_channels(file.output(), spec);
    const auto channels = size_t(drawn.nchannels);
    const std::vector<float> values =
        values_of(columns, points.mesh.x.size(), channels, size_t(drawn.alpha_channel));
    std::vector<float> pixels(drawn.image_pixels() * channels, 0.0f);
    std::vector<uint8_t> inside(drawn.image_pixels());
    if (!draw(points.mesh, values.data(), int(channels), grid, pixels.data(), inside.data(),
              &failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    if (std::count(inside.begin(), inside.end(), uint8_t(0)) == std::ptrdiff_t(inside.size())) {
        const Window w = window_of(points.mesh);
        note(format(
            "\"{}\" is empty: no pixel lies on a triangle; they span {:.12g},{:.12g},{:.12g},"
            "{:.12g}",
            path, w.x0, w.y0, w.x1, w.y1));
    }
    if (linear)
        make_linear(columns, drawn, pixels);
    keep_first(size_t(spec.nchannels), channels, pixels);
    if (!file.open(spec, failure))
        return false;
    note_left_out(path, left_out);
    if (!file.output().spec().format.is_floating_point() &&
        std::any_of(pixels.begin(), pixels.end(), [](float v) { return v < 0 || v > 1; }))
        note("\"" + path + "\" holds 0 to 1; what is beyond is cut off");
    const OIIO::ImageBuf image(spec, pixels.data());
    return write_image(image, file, failure);
}

} // namespace ddt::tool
