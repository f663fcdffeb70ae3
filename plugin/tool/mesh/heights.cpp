// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/mesh/heights.h"

#include "ddt/guide.h"
#include "plugin/image/channels.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/pixels.h"
#include "plugin/image/windows.h"
#include "plugin/tool/file/unassociated.h"

namespace ddt::tool {

namespace {

/// Where no channel is shown as colour, as in an image of alpha alone, the first counts.
float height_of(const ColourLayout& shown, const float* pixel) {
    if (shown.count < 3)
        return pixel[shown.count ? shown.channel[0] : 0];
    double luminance = 0; // of white exactly 1
    for (int k = 0; k < 3; ++k)
        luminance += double(luminance_weights[k]) * double(pixel[shown.channel[k]]);
    return float(luminance);
}

} // namespace

bool read_heights(const std::string& path, const OIIO::ImageBuf& image,
                  const OIIO::ImageBuf& filled, std::vector<float>& heights, std::string& error) {
    Unassociated in_file;
    if (may_be_unassociated(image) && !in_file.read(path, error))
        return false;
    if (in_file && in_file.image().roi() != image.roi()) {
        error = why_changed(path);
        return false;
    }
    if (in_file && &filled != &image)
        in_file.put(image, filled);
    const OIIO::ImageBuf& from = in_file ? in_file.image() : filled;
    const ColourLayout shown = shown_colour(channels_of(from.spec(), from.nativespec()));
    const Rect window = rect_of(from.roi());
    const auto channels = size_t(from.nchannels());
    std::vector<float> row(size_t(window.width()) * channels);
    heights.clear();
    heights.reserve(window.area());
    for (int y = window.y0; y < window.y1; ++y) {
        if (!read_pixels(from, {window.x0, y, window.x1, y + 1}, 0, int(channels), OIIO::TypeFloat,
                         row.data(), error))
            return false;
        for (size_t i = 0; i < row.size(); i += channels)
            heights.push_back(height_of(shown, &row[i]));
    }
    return true;
}

} // namespace ddt::tool
