// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/colour_channels.h"

#include <algorithm>
#include <numeric>

namespace ddt {
namespace {

using MayBe = std::function<bool(int channel)>;

bool is_depth(const std::string& name) {
    const std::vector<std::string> pieces = pieces_of(name);
    return is_any_of(pieces.back(), {"Z"}) ||
           std::any_of(pieces.begin(), pieces.end(),
                       [](const std::string& piece) { return is_any_of(piece, {"depth"}); });
}

/// Whether the channel is one that OpenImageIO's maketexture.cpp makes of a bump map.
bool is_slope(const std::string& name) {
    return is_any_of(name, {"b0_h", "b1_dhds", "b2_dhdt", "b3_dhds2", "b4_dhdt2", "b5_dh2dsdt"});
}

/// Cyan, magenta, yellow and, if there is one, black of a layer; none without the first three.
std::vector<int> inks_of(const OIIO::ImageSpec& spec, const Layer& layer) {
    // Printers may have given the four other names.
    if (layer.name.empty() && layer.channels.size() >= 4 &&
        is_any_of(spec.get_string_attribute("oiio:ColorSpace"), {"CMYK"}))
        return {layer.channels.begin(), layer.channels.begin() + 4};
    std::vector<int> inks{layer.find({"C", "cyan"}), layer.find({"M", "magenta"}),
                          layer.find({"Y", "yellow"})};
    if (std::find(inks.begin(), inks.end(), -1) != inks.end())
        return {};
    if (const int black = layer.find({"K", "black"}); black >= 0)
        inks.push_back(black);
    return inks;
}

/// Set `rgb` to a layer's red, green and blue; false without all three.
bool find_triple(const Layer& layer, int (&rgb)[3]) {
    rgb[0] = layer.find({"R", "red"});
    rgb[1] = layer.find({"G", "green"});
    rgb[2] = layer.find({"B", "blue"});
    return rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0;
}

/// The higher, the likelier it is by a layer's name that the picture itself is there.
int rank_of(const Layer& layer) {
    if (layer.name.empty())
        return 4;
    const auto is_picture = [](const std::string& piece) {
        return is_any_of(piece, {"Combined", "beauty", "rgba", "rgb", "C", "color", "colour"});
    };
    const std::vector<std::string> pieces = pieces_of(layer.name);
    if (is_picture(pieces.back()))
        return 3;
    if (std::any_of(pieces.begin(), pieces.end(), is_picture))
        return 2;
    return is_depth(layer.name) ? 0 : 1;
}

/// The layer whose red, green and blue are the image's, or null.
const Layer* find_layer(const std::vector<Layer>& layers, const MayBe& may_be) {
    const Layer* best = nullptr;
    for (const Layer& layer : layers) {
        int rgb[3];
        if (find_triple(layer, rgb) && std::all_of(rgb, rgb + 3, may_be) &&
            (!best || rank_of(layer) > rank_of(*best)))
            best = &layer;
    }
    return best;
}

/// The only channel that may be colour, or -1.
int find_only(int count, const MayBe& may_be) {
    int only = -1;
    for (int c = 0; c < count; ++c)
        if (may_be(c)) {
            if (only >= 0)
                return -1;
            only = c;
        }
    return only;
}

} // namespace

std::vector<Quantity> quantities_of(const OIIO::ImageSpec& spec, const std::vector<Layer>& layers) {
    std::vector<Quantity> quantities(size_t(spec.nchannels), Quantity::other);
    for (const Layer& layer : layers) {
        int rgb[3];
        const bool is_colour = find_triple(layer, rgb);
        const bool xy = layer.find({"X"}) >= 0 && layer.find({"Y"}) >= 0;
        const bool uv = layer.find({"U"}) >= 0 && layer.find({"V"}) >= 0;
        const std::vector<int> inks = is_colour ? std::vector<int>() : inks_of(spec, layer);
        for (size_t i = 0; i < layer.channels.size(); ++i) {
            const std::string& component = layer.components[i];
            const int c = layer.channels[i];
            if (const auto ink = std::find(inks.begin(), inks.end(), c); ink != inks.end())
                quantities[size_t(c)] = Quantity(int(Quantity::cyan) + int(ink - inks.begin()));
            else if (is_slope(component))
                quantities[size_t(c)] = Quantity::slope;
            else if ((xy && is_any_of(component, {"X", "Y", "Z", "W"})) ||
                     (uv && is_any_of(component, {"U", "V", "W"})))
                quantities[size_t(c)] = Quantity::vector;
            else if (c == spec.z_channel || (!is_colour && is_depth(spec.channel_name(c))))
                quantities[size_t(c)] = Quantity::depth;
        }
    }
    return quantities;
}

ColourChannels find_colour(const OIIO::ImageSpec& spec, const std::vector<Layer>& layers,
                           const std::vector<Quantity>& quantities, const MayBe& may_be) {
    ColourChannels found;
    int(&channel)[3] = found.layout.channel;
    const int grey = find_channel(spec, {"Y", "L", "I", "luminance", "gray", "grey"});
    const bool has_grey = grey >= 0 && may_be(grey);
    found.layer = find_layer(layers, may_be);
    if (found.layer && has_grey && !found.layer->name.empty())
        found.layer = nullptr; // what is no layer's is the picture
    if (found.layer) {
        find_triple(*found.layer, channel);
        found.layout.count = 3;
    } else if (!has_grey && spec.nchannels >= 3 && may_be(0) && may_be(1) && may_be(2)) {
        std::iota(channel, channel + 3, 0);
        found.layout.count = 3;
    } else {
        const bool inks = std::any_of(quantities.begin(), quantities.end(), is_ink);
        channel[0] = has_grey ? grey : inks ? -1 : find_only(spec.nchannels, may_be);
        found.layout.count = channel[0] >= 0 ? 1 : 0;
    }
    return found;
}

int alpha_of_colour(int alpha, const std::vector<Layer>& layers, const Layer* layer,
                    const std::function<bool(int channel)>& is_id) {
    const auto has = [](const Layer& of, int c) {
        return std::binary_search(of.channels.begin(), of.channels.end(), c);
    };
    if (alpha >= 0 && layer && !has(*layer, alpha)) {
        const int own = layer->find({"A", "alpha"});
        if (own >= 0 && !is_id(own))
            return own;
        int others[3];
        for (const Layer& other : layers)
            if (has(other, alpha) && find_triple(other, others))
                return -1;
    }
    return alpha >= 0 && !is_id(alpha) ? alpha : -1;
}

} // namespace ddt
