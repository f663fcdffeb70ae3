// SPDX-License-Identifier: Apache-2.0
#include "reference.h"

#include <algorithm>
#include <filesystem>

#include <OpenImageIO/imagebufalgo.h>

namespace bench {

std::vector<std::string> image_files(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.is_regular_file() && OIIO::ImageInput::open(entry.path().string()))
            files.push_back(entry.path().string());
    OIIO::geterror(); // what was left out is no error
    std::sort(files.begin(), files.end());
    return files;
}

bool read_original(const std::string& path, int scale, Light light, metrics::Image& image,
                   std::string& error) {
    OIIO::ImageBuf file(path);
    if (!file.read(0, 0, true, OIIO::TypeDesc::FLOAT)) {
        error = file.geterror();
        return false;
    }
    bool scene = light == Light::scene;
    if (file.nativespec().format.is_floating_point() != scene) {
        error = scene ? "its pixels are integers, not scene light"
                      : "its pixels are floating point, which has no white to measure against";
        return false;
    }
    const OIIO::ImageSpec& spec = file.spec();
    int width = spec.width / scale * scale, height = spec.height / scale * scale;
    if (width < 3 * scale || height < 3 * scale) {
        error = "it is too small";
        return false;
    }
    bool colour = spec.nchannels >= 3;
    for (metrics::Plane& plane : image.channels)
        plane = metrics::Plane(width, height);
    for (OIIO::ImageBuf::ConstIterator<float> it(
             file, OIIO::ROI(spec.x, spec.x + width, spec.y, spec.y + height));
         !it.done(); ++it) {
        float alpha = spec.alpha_channel >= 0 ? it[spec.alpha_channel] : 1.0f;
        for (int c = 0; c < 3; ++c) {
            auto v = double(it[colour ? c : 0]);
            image.channels[c].at(it.x() - spec.x, it.y() - spec.y) =
                scene ? encode_log(v) : 255 * (v + 1 - double(alpha));
        }
    }
    image = stored(image, light);
    return true;
}

namespace {

metrics::Image box_means(const metrics::Image& image, int scale, Light light) {
    metrics::Image out;
    for (int c = 0; c < 3; ++c) {
        metrics::Plane small(image.width() / scale, image.height() / scale);
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                double sum = 0;
                for (int j = 0; j < scale; ++j)
                    for (int i = 0; i < scale; ++i)
                        sum += decode(image.channels[c].at(x * scale + i, y * scale + j), light);
                small.at(x, y) = encode(sum / (scale * scale), light);
            }
        out.channels[c] = std::move(small);
    }
    return out;
}

} // namespace

metrics::Image reduced(const metrics::Image& image, int scale, Light light, Reduce reduce) {
    if (reduce == Reduce::box)
        return stored(box_means(image, scale, light), light);
    OIIO::ROI roi(0, image.width() / scale, 0, image.height() / scale, 0, 1, 0, 3);
    return stored(
        to_display(OIIO::ImageBufAlgo::resize(to_light(image, light), "catmull-rom", 0, roi),
                   light),
        light);
}

} // namespace bench
