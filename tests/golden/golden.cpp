// SPDX-License-Identifier: Apache-2.0
// The pixels that come out, pinned: every image of testimages/ through ddt::resize with each
// filter, fitted weights and averaged meshes at two factors, as a table of hashes.
//
//   golden TESTIMAGES TABLE             compares; prints each line that differs
//   golden --update TESTIMAGES TABLE    writes the table anew
//
// When the arithmetic changes on purpose: cmake --build build --target update_golden, look at what
// changed in the pictures, and commit the table with the change. Hashes that change without a
// purpose are a bug. $OCIO must not be set: colour goes by the config that is built in.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "ddt/resize.h"
#include "tests/fnv.h"

namespace {

/// Of the pixels' bits in their own format, and of the windows.
std::string hash_of(const OIIO::ImageBuf& image) {
    const OIIO::ImageSpec& spec = image.spec();
    const int windows[] = {spec.x,          spec.y,           spec.width,
                           spec.height,     spec.full_x,      spec.full_y,
                           spec.full_width, spec.full_height, spec.nchannels};
    std::vector<unsigned char> pixels(spec.image_bytes());
    image.get_pixels(image.roi(), spec.format, pixels.data());
    const uint64_t hash =
        ddt::test::fnv(pixels.data(), pixels.size(), ddt::test::fnv(windows, sizeof windows));
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

/// Data and display window `scale` times as large. Where the data window's border falls within a
/// pixel, the pixel belongs to it.
OIIO::ROI scaled_data(const OIIO::ImageSpec& spec, double scale) {
    auto low = [&](int v) { return int(std::floor(v * scale)); };
    auto high = [&](int v) { return int(std::ceil(v * scale)); };
    return {
        low(spec.x),   high(spec.x + spec.width), low(spec.y), high(spec.y + spec.height), 0, 1, 0,
        spec.nchannels};
}

/// The hash, or the text of the error.
std::string result_of(const OIIO::ImageBuf& image, const std::string& filter, double scale) {
    OIIO::ImageSpec spec = image.spec();
    OIIO::ROI data = scaled_data(spec, scale);
    spec.x = data.xbegin;
    spec.y = data.ybegin;
    spec.width = data.width();
    spec.height = data.height();
    spec.full_width = int(std::lround(spec.full_width * scale));
    spec.full_height = int(std::lround(spec.full_height * scale));
    OIIO::ImageBuf result(spec);
    ddt::Options options;
    std::string error;
    if (!ddt::parse_filter(filter, options, error))
        return error;
    if (!ddt::resize(result, image, options))
        return result.geterror();
    return hash_of(result);
}

/// Multiply the colours of 8-bit pixels by alpha, as OpenImageIO 2.4 does with a PNG's.
void associate(OIIO::ImageBuf& image) {
    const OIIO::ImageSpec& spec = image.spec();
    const int alpha = spec.alpha_channel, channels = spec.nchannels;
    std::vector<uint8_t> pixels(spec.image_bytes());
    image.get_pixels(image.roi(), OIIO::TypeUInt8, pixels.data());
    for (size_t i = 0; i < pixels.size(); i += size_t(channels))
        for (int c = 0; c < channels; ++c)
            if (c != alpha)
                pixels[i + size_t(c)] =
                    uint8_t(pixels[i + size_t(c)] * pixels[i + size_t(alpha)] / 255);
    image.set_pixels(image.roi(), OIIO::TypeUInt8, pixels.data());
}

/// The same pixels by any OpenImageIO: 2.5 and 3 associate colour with alpha otherwise than 2.4.
OIIO::ImageBuf read_image(const std::string& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf image(path, 0, 0, nullptr, &config);
    image.read(0, 0, true);
    // Of pictures without alpha it is said too.
    if (image.spec().get_int_attribute("oiio:UnassociatedAlpha") != 0 &&
        image.spec().alpha_channel >= 0)
        associate(image);
    image.specmod().erase_attribute("oiio:UnassociatedAlpha");
    return image;
}

/// "file filter factor" to hash.
using Table = std::map<std::string, std::string>;

Table compute(const std::string& folder) {
    Table table;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string extension = entry.path().extension();
        if (extension != ".png" && extension != ".exr")
            continue;
        const OIIO::ImageBuf image = read_image(entry.path().string());
        std::vector<std::string> filters = ddt::filter_names();
        filters.insert(filters.end(), {"ddt-sharp,clipped=1", "ddt,meshes=2"});
        for (const std::string& filter : filters)
            for (double scale : {1.4, 2.5, 3.0}) {
                std::ostringstream key;
                key << entry.path().filename().string() << " " << filter << " " << scale;
                table[key.str()] = result_of(image, filter, scale);
            }
    }
    return table;
}

Table read(const std::string& path) {
    Table table;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        size_t end = line.rfind(' ');
        if (end != std::string::npos && line[0] != '#')
            table[line.substr(0, end)] = line.substr(end + 1);
    }
    return table;
}

bool write(const Table& table, const std::string& path) {
    std::ofstream file(path);
    file << "# image, filter, factor, hash of the result's pixels; see golden.cpp\n";
    for (const auto& [key, hash] : table)
        file << key << " " << hash << "\n";
    return bool(file.flush());
}

int compare(const Table& found, const Table& expected) {
    int differences = 0;
    auto report = [&](const std::string& key, const std::string& is, const std::string& was) {
        std::printf("%-36s is %s, expected %s\n", key.c_str(), is.c_str(), was.c_str());
        ++differences;
    };
    for (const auto& [key, hash] : found) {
        auto was = expected.find(key);
        if (was == expected.end())
            report(key, hash, "nothing: not in the table");
        else if (was->second != hash)
            report(key, hash, was->second);
    }
    for (const auto& [key, hash] : expected)
        if (!found.count(key))
            report(key, "missing", hash);
    return differences;
}

} // namespace

int main(int argc, char** argv) {
    bool update = argc == 4 && std::strcmp(argv[1], "--update") == 0;
    if (argc != 3 && !update) {
        std::fprintf(stderr, "usage: golden [--update] TESTIMAGES TABLE\n");
        return 2;
    }
    const std::string folder = argv[argc - 2], path = argv[argc - 1];
    Table found = compute(folder);
    if (update)
        return write(found, path) ? 0 : 1;
    return compare(found, read(path)) == 0 && !found.empty() ? 0 : 1;
}
