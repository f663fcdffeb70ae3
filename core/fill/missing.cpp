// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/float_mode.h"
#include "core/fill/fill.h"

namespace ddt {

namespace {

bool is_kind(const HoledImage& image, size_t channel, Channel kind) {
    return (image.kinds ? image.kinds[channel] : Channel::blend) == kind;
}

/// Whether a pixel's alpha says that there is none.
bool is_empty(const HoledImage& image, const float* pixel) {
    for (size_t c = 0; c < size_t(image.channels); ++c)
        if (is_kind(image, c, Channel::alpha) && pixel[c] == 0.0f)
            return true;
    return false;
}

/// Holes have few triangles, and they are long: worth looking ahead.
MeshOptions for_holes(MeshOptions options) {
    if (options.scheme == Scheme::one_round)
        options.scheme = Scheme::look_ahead;
    options.min_gain = -1;
    return options;
}

} // namespace

bool find_missing(const HoledImage& image, Holes holes, std::vector<uint8_t>& missing) {
    const DenormalsAreZero as_on_gpus;
    const auto channels = size_t(image.channels);
    missing.assign(size_t(image.width) * size_t(image.height), 0);
    bool any = false;
    for (size_t i = 0; holes != Holes::keep && i < missing.size(); ++i) {
        const float* pixel = image.values + i * channels;
        bool is = holes == Holes::fill_alpha && is_empty(image, pixel);
        for (size_t c = 0; c < channels; ++c)
            is |= std::isnan(pixel[c]) && !is_kind(image, c, Channel::nearest);
        missing[i] = is;
        any |= is;
    }
    return any;
}

bool fill_missing(const HoledImage& image, Holes holes, const MeshOptions& options, Device device,
                  const ProgressCallback& progress, MeshReport* report, std::string& error) {
    const DenormalsAreZero as_on_gpus;
    std::vector<uint8_t> missing;
    if (!find_missing(image, holes, missing))
        return true;
    const auto channels = size_t(image.channels);
    // What missing pixels have all the same, in the order of the pixels.
    const auto has_some = [&](size_t i) {
        const float* pixel = image.values + i * channels;
        return !(holes == Holes::fill_alpha && is_empty(image, pixel)) &&
               !std::all_of(pixel, pixel + channels, [](float v) { return std::isnan(v); });
    };
    std::vector<size_t> partial;
    for (size_t i = 0; i < missing.size(); ++i)
        if (missing[i] && has_some(i))
            partial.push_back(i);
    std::vector<float> had;
    had.reserve(partial.size() * channels);
    for (const size_t i : partial)
        had.insert(had.end(), image.values + i * channels, image.values + (i + 1) * channels);
    if (!fill_holes(image, missing.data(), for_holes(options), device, progress, report, error))
        return false;
    const float* old = had.data();
    for (const size_t i : partial)
        for (size_t c = 0; c < channels; ++c, ++old)
            if (!std::isnan(*old))
                image.values[i * channels + c] = *old;
    return true;
}

} // namespace ddt
