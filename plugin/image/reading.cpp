// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/reading.h"

#include <algorithm>
#include <memory>

#include "plugin/colour/colour_pixels.h"
#include "plugin/colour/space_light.h"

namespace ddt {
namespace {

/// The channels the core works on: those wanted, then what the way back from linear light needs,
/// then the rest of the first `all`.
std::vector<int> select(const Reading& reading, const OIIO::ROI& roi, int all) {
    std::vector<int> selected;
    for (int c = roi.chbegin; c < roi.chend; ++c)
        selected.push_back(c);
    const ColourLayout& colour = reading.channels.colour;
    const auto wanted = [&](int c) { return c >= roi.chbegin && c < roi.chend; };
    if (reading.light.converts() &&
        std::any_of(colour.channel, colour.channel + colour.count, wanted)) {
        for (int k = 0; k < colour.count; ++k)
            if (!wanted(colour.channel[k]))
                selected.push_back(colour.channel[k]);
        if (colour.alpha >= 0 && !wanted(colour.alpha))
            selected.push_back(colour.alpha);
    }
    for (int c = 0; c < all; ++c)
        if (std::find(selected.begin(), selected.end(), c) == selected.end())
            selected.push_back(c);
    return selected;
}

GuideRecipe recipe(const Channels& channels, const Light& light, bool linear) {
    GuideRecipe guide = guide_recipe(light, channels.colour, linear);
    guide.alpha = channels.alpha;
    // Any of them may be where an edge is. Weights are alike, but not the same: what one channel
    // gains where another loses as much, as two mattes side by side, is an edge too.
    static constexpr float shares[3][3] = {{1.0f}, {0.6f, 0.4f}, {0.45f, 0.33f, 0.22f}};
    const size_t count = std::min<size_t>(channels.guide.size(), 3);
    for (size_t k = 0; k < count; ++k) {
        guide.channel[k] = channels.guide[k];
        guide.weight[k] = shares[count - 1][k];
    }
    // Black takes alpha's place, with its share of a half: it covers what is beneath, too. An
    // alpha's edges are also those of the inks that are multiplied by it.
    if (channels.guide.size() > count)
        guide.alpha = channels.guide.back();
    return guide;
}

/// Whether the file behind the image has integers.
bool of_integers(const OIIO::ImageBuf& src) {
    const OIIO::TypeDesc stored = src.nativespec().format;
    return stored != OIIO::TypeUnknown && !stored.is_floating_point();
}

} // namespace

bool check_options_of(const OIIO::ImageBuf& src, const Options& options, std::string& error) {
    // Of `auto` the image says what it means.
    return check_options(options, error) &&
           (options.light == "auto" || check_light(src.spec(), src.nativespec(), options, error));
}

bool check_light(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& native, const Options& options,
                 std::string& error) {
    return options.light == "encoded" ||
           (options.light == "auto" && channels_of(spec, native).colour.count == 0) ||
           find_light(options.light, spec.get_string_attribute("oiio:ColorSpace"), error);
}

bool plan_reading(const OIIO::ImageBuf& src, const Options& options, const OIIO::ROI& roi,
                  Reading& reading, std::string& error) {
    const OIIO::ImageSpec& spec = src.spec();
    reading.channels = channels_of(spec, src.nativespec());
    const bool encoded = options.light == "encoded";
    std::shared_ptr<const Light> light = std::make_shared<Light>();
    if (reading.channels.colour.count) {
        std::string why;
        auto found = find_light(options.light, spec.get_string_attribute("oiio:ColorSpace"), why);
        if (!found && !encoded) {
            error = why;
            return false;
        }
        // With light=encoded a space only tells how to look at the numbers; without one it is
        // guessed below.
        if (found)
            light = found;
    }
    const bool as_it_is = encoded || !light->comes_back();
    // Numbers that are not converted are looked at as they are when they are an encoding, or
    // integers of which nobody says: those mostly are one, also where a host holds a file's
    // integers as floats.
    const bool linear = light->known() ? !(as_it_is && light->converts())
                                       : spec.format.is_floating_point() && !of_integers(src);
    reading.guide = recipe(reading.channels, *light, linear);
    if (!as_it_is)
        reading.light = *light;
    // IDs are neither NaN nor to be interpolated.
    const bool fill = options.holes != Holes::keep && !reading.channels.raw;
    reading.keep_nan = fill;
    reading.selected = select(reading, roi, fill ? spec.nchannels : 0);
    return true;
}

} // namespace ddt
