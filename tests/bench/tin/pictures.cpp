// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "tables.h"

namespace ddt::bench {

namespace {

/// A picture's numbers as they are in the file, 0 to 1.
struct Picture {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values, guide;
    size_t size() const { return size_t(width) * size_t(height); }
};

/// The middle crop x crop pixels of a file.
bool load(const std::string& file, int crop, Picture& picture) {
    OIIO::ImageBuf image(file);
    if (!image.read(0, 0, true)) {
        std::fprintf(stderr, "\"%s\": %s\n", file.c_str(), image.geterror().c_str());
        return false;
    }
    OIIO::ROI roi = image.roi();
    const int w = std::min(crop, roi.width()), h = std::min(crop, roi.height());
    roi.xbegin += (roi.width() - w) / 2;
    roi.ybegin += (roi.height() - h) / 2;
    roi.xend = roi.xbegin + w;
    roi.yend = roi.ybegin + h;
    roi.chend = std::min(roi.chend, 3);
    picture = {w, h, roi.nchannels(), {}, {}};
    picture.values.resize(picture.size() * size_t(picture.channels));
    if (!image.get_pixels(roi, OIIO::TypeFloat, picture.values.data())) {
        std::fprintf(stderr, "\"%s\": %s\n", file.c_str(), image.geterror().c_str());
        return false;
    }
    for (size_t i = 0; i < picture.size(); ++i) {
        const float* p = &picture.values[i * size_t(picture.channels)];
        picture.guide.push_back(
            picture.channels == 3 ? 0.299f * p[0] + 0.587f * p[1] + 0.114f * p[2] : p[0]);
    }
    return true;
}

double decibels(double squares, double count) {
    return -10 * std::log10(squares / count);
}

double squares_between(const Picture& a, const std::vector<float>& b, size_t pixel) {
    double sum = 0;
    for (size_t c = 0; c < size_t(a.channels); ++c) {
        const size_t i = pixel * size_t(a.channels) + c;
        sum += (double(a.values[i]) - double(b[i])) * (double(a.values[i]) - double(b[i]));
    }
    return sum;
}

void print_head(const std::string& title, const std::vector<Way>& ways, const char* first) {
    std::printf("\n%s\n%-28s", title.c_str(), "");
    if (first)
        std::printf(" %10s", first);
    for (const Way& way : ways)
        std::printf(" %10s", way.name.c_str());
    std::printf("\n");
}

std::string name_of(const std::string& file) {
    return file.substr(file.find_last_of('/') + 1);
}

/// Print a row and add it to the means.
void print_row(const std::string& name, const std::vector<double>& row, std::vector<double>& sums) {
    std::printf("%-28s", name.c_str());
    sums.resize(row.size());
    for (size_t k = 0; k < row.size(); ++k) {
        std::printf(" %10.2f", row[k]);
        sums[k] += row[k];
    }
    std::printf("\n");
}
void print_means(std::vector<double> sums, size_t count) {
    std::vector<double> unused;
    for (double& s : sums)
        s /= double(count);
    print_row("mean", sums, unused);
}

/// What fillholes_pushpull makes of it.
std::vector<float> push_pull(const Picture& picture, const std::vector<uint8_t>& missing) {
    const int channels = picture.channels + 1;
    OIIO::ImageSpec spec(picture.width, picture.height, channels, OIIO::TypeFloat);
    spec.alpha_channel = picture.channels;
    std::vector<float> values;
    for (size_t i = 0; i < picture.size(); ++i) {
        for (int c = 0; c < picture.channels; ++c)
            values.push_back(missing[i] ? 0.0f
                                        : picture.values[i * size_t(picture.channels) + size_t(c)]);
        values.push_back(missing[i] ? 0.0f : 1.0f);
    }
    const OIIO::ImageBuf image(spec, values.data());
    const OIIO::ImageBuf filled = OIIO::ImageBufAlgo::fillholes_pushpull(image);
    std::vector<float> result(picture.values.size());
    OIIO::ROI roi = filled.roi();
    roi.chend = picture.channels;
    filled.get_pixels(roi, OIIO::TypeFloat, result.data());
    return result;
}

std::vector<uint8_t> missing_pixels(const Picture& picture, bool blocks) {
    std::vector<uint8_t> missing(picture.size(), 0);
    test::Random random(blocks ? 2 : 1);
    constexpr int side = 20, spacing = 64;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const int u = x % spacing - (spacing - side) / 2,
                      v = y % spacing - (spacing - side) / 2;
            missing[size_t(y) * size_t(picture.width) + size_t(x)] =
                blocks ? u >= 0 && u < side && v >= 0 && v < side : share_of(random) < 0.1;
        }
    return missing;
}

} // namespace

bool print_pictures(const std::vector<Way>& ways, const std::vector<std::string>& files, int crop,
                    double share) {
    char title[80];
    std::snprintf(title, sizeof title, "From %g %% of the pixels: PSNR, dB", 100 * share);
    print_head(title, ways, nullptr);
    std::vector<double> sums;
    for (const std::string& file : files) {
        Picture picture;
        if (!load(file, crop, picture))
            return false;
        PointMesh mesh;
        std::vector<float> values, guide;
        test::Random random(5);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const bool corner =
                    (x == 0 || x == picture.width - 1) && (y == 0 || y == picture.height - 1);
                if (share_of(random) >= share && !corner)
                    continue;
                const size_t i = size_t(y) * size_t(picture.width) + size_t(x);
                mesh.x.push_back(x);
                mesh.y.push_back(y);
                guide.push_back(picture.guide[i]);
                const float* p = &picture.values[i * size_t(picture.channels)];
                values.insert(values.end(), p, p + picture.channels);
            }
        std::string error;
        std::vector<double> row;
        if (!delaunay(mesh, &error)) {
            std::fprintf(stderr, "%s\n", error.c_str());
            return false;
        }
        for (const Way& way : ways) {
            PointMesh flipped = mesh;
            std::vector<float> raster(picture.values.size());
            std::vector<uint8_t> inside(picture.size());
            if (!optimise(flipped, guide.data(), way.options, nullptr, &error) ||
                !draw(flipped, values.data(), picture.channels,
                      {0, 0, 1, 1, picture.width, picture.height}, raster.data(), inside.data(),
                      &error)) {
                std::fprintf(stderr, "%s\n", error.c_str());
                return false;
            }
            double squares = 0;
            for (size_t i = 0; i < picture.size(); ++i)
                squares += squares_between(picture, raster, i);
            row.push_back(decibels(squares, double(picture.values.size())));
        }
        print_row(name_of(file), row, sums);
    }
    print_means(sums, files.size());
    return true;
}

bool print_fill(const std::vector<Way>& ways, const std::vector<std::string>& files, int crop) {
    for (const bool blocks : {false, true}) {
        print_head(blocks ? "Blocks of 20 x 20 missing: PSNR over them, dB"
                          : "10 % of the pixels missing: PSNR over them, dB",
                   ways, "push-pull");
        std::vector<double> sums;
        for (const std::string& file : files) {
            Picture picture;
            if (!load(file, crop, picture))
                return false;
            const std::vector<uint8_t> missing = missing_pixels(picture, blocks);
            const auto over_holes = [&](const std::vector<float>& filled) {
                double squares = 0, count = 0;
                for (size_t i = 0; i < picture.size(); ++i)
                    if (missing[i]) {
                        squares += squares_between(picture, filled, i);
                        count += picture.channels;
                    }
                return decibels(squares, count);
            };
            std::vector<double> row{over_holes(push_pull(picture, missing))};
            for (const Way& way : ways) {
                std::vector<float> filled = picture.values;
                std::string error;
                if (!fill_holes(filled.data(), picture.width, picture.height, picture.channels,
                                nullptr, picture.guide.data(), missing.data(), way.options,
                                &error)) {
                    std::fprintf(stderr, "%s\n", error.c_str());
                    return false;
                }
                row.push_back(over_holes(filled));
            }
            print_row(name_of(file), row, sums);
        }
        print_means(sums, files.size());
    }
    return true;
}

} // namespace ddt::bench
