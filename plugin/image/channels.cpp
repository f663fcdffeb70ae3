// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/channels.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "plugin/image/colour_channels.h"
#include "plugin/image/id_names.h"

namespace ddt {
namespace {

/// Of each channel whether its numbers are IDs.
std::vector<bool> find_ids(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& native,
                           const std::vector<Layer>& layers) {
    // A file's channels may each have a type of their own, where the image has one for all.
    const bool same_channels = native.nchannels == spec.nchannels;
    const auto stored_as_id = [&](int c) {
        return is_id_type(spec.format) ||
               is_id_type(same_channels ? native.channelformat(c) : native.format);
    };
    // Of a file's parts each may be a layer, whose channels are R, G, B and A then, or one of any
    // name.
    const std::string part(spec.get_string_attribute("oiio:subimagename"));
    const bool part_of_ids = spec.nchannels == 1 && is_id_name(part);
    const std::vector<std::string> known = cryptomattes(spec);
    std::vector<bool> ids(size_t(spec.nchannels), part_of_ids);
    for (const Layer& layer : layers)
        for (const int c : layer.channels) {
            const std::string name = spec.channel_name(c);
            if (stored_as_id(c) || is_id_name(name) || is_layer_of_ids(layer) ||
                is_cryptomatte(name, known) || is_cryptomatte(part + "." + name, known))
                ids[size_t(c)] = true;
        }
    return ids;
}

/// The first channels in which edges are sought where nothing is called colour: inks and then their
/// black, else those that blend, of depth only where there is nothing else.
std::vector<int> find_guide(const std::vector<Channel>& kinds,
                            const std::vector<Quantity>& quantities) {
    const auto first = [&](size_t most, std::initializer_list<Quantity> wanted) {
        std::vector<int> found;
        for (size_t c = 0; c < kinds.size() && found.size() < most; ++c)
            if (kinds[c] == Channel::blend &&
                std::find(wanted.begin(), wanted.end(), quantities[c]) != wanted.end())
                found.push_back(int(c));
        return found;
    };
    std::vector<int> guide;
    for (const Quantity ink :
         {Quantity::cyan, Quantity::magenta, Quantity::yellow, Quantity::black}) {
        const std::vector<int> found = first(1, {ink});
        guide.insert(guide.end(), found.begin(), found.end());
    }
    if (!guide.empty())
        return guide;
    guide = first(3, {Quantity::vector, Quantity::slope, Quantity::other});
    return guide.empty() ? first(1, {Quantity::depth}) : guide;
}

int alpha_among(const OIIO::ImageSpec& spec, const std::vector<Quantity>& quantities) {
    const int said = std::max(spec.alpha_channel, -1);
    const auto may_be = [](Quantity q) { return q != Quantity::slope && !is_ink(q); };
    return said < 0 || (said < spec.nchannels && may_be(quantities[size_t(said)]))
               ? said
               : find_channel(spec, {"A", "alpha"});
}

} // namespace

bool is_id_type(OIIO::TypeDesc type) {
    return type == OIIO::TypeDesc::UINT32 || type == OIIO::TypeDesc::INT32;
}

int alpha_of(const OIIO::ImageSpec& spec) {
    return alpha_among(spec, quantities_of(spec, layers_of(spec)));
}

Channels channels_of(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& native) {
    const std::vector<Layer> layers = layers_of(spec);
    const std::vector<bool> ids = find_ids(spec, native, layers);
    const std::vector<Quantity> quantities = quantities_of(spec, layers);
    const auto is_id = [&](int c) { return bool(ids[size_t(c)]); };
    const int alpha = alpha_among(spec, quantities);
    const ColourChannels found = find_colour(spec, layers, quantities, [&](int c) {
        return c != alpha && !is_id(c) && quantities[size_t(c)] == Quantity::other;
    });

    Channels channels;
    channels.raw = is_id_type(spec.format);
    channels.colour = found.layout;
    channels.alpha = channels.raw ? alpha : alpha_of_colour(alpha, layers, found.layer, is_id);
    for (int c = 0; c < spec.nchannels; ++c)
        channels.kinds.push_back(is_id(c)              ? Channel::nearest
                                 : c == channels.alpha ? Channel::alpha
                                                       : Channel::blend);
    if (!found.layer && found.layout.count != 1)
        channels.guide = find_guide(channels.kinds, quantities);
    // Readers keep colour unassociated when asked to, and say so.
    if (found.layout.count && !spec.get_int_attribute("oiio:UnassociatedAlpha"))
        channels.colour.alpha = channels.alpha;
    return channels;
}

ColourLayout shown_colour(const Channels& channels) {
    ColourLayout shown = channels.colour;
    if (shown.count == 0 && !channels.guide.empty()) {
        shown.count = channels.guide.size() >= 3 ? 3 : 1;
        std::copy_n(channels.guide.begin(), shown.count, shown.channel);
    }
    return shown;
}

} // namespace ddt
