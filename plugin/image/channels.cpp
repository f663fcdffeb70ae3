// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/channels.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <string>

#include <OpenImageIO/strutil.h>

namespace ddt {
namespace {

using OIIO::Strutil::iends_with;
using OIIO::Strutil::iequals;
using OIIO::Strutil::istarts_with;

bool letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c));
}
bool digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c));
}
bool upper(char c) {
    return std::isupper(static_cast<unsigned char>(c));
}

/// `name` is layer, then two digits, then nothing or a dot and more: a rank of a cryptomatte.
bool is_rank_of(OIIO::string_view name, OIIO::string_view layer) {
    if (layer.empty() || !istarts_with(name, layer))
        return false;
    name.remove_prefix(layer.size());
    return name.size() >= 2 && digit(name[0]) && digit(name[1]) &&
           (name.size() == 2 || name[2] == '.');
}

/// Names of the image's cryptomattes, from the metadata "cryptomatte/<key>/name".
std::vector<std::string> cryptomattes(const OIIO::ImageSpec& spec) {
    std::vector<std::string> names;
    for (const auto& attribute : spec.extra_attribs)
        if (istarts_with(attribute.name(), "cryptomatte/") && iends_with(attribute.name(), "/name"))
            names.push_back(attribute.get_string());
    return names;
}

/// Also without metadata: "CryptoObject00.R" and its like, of a layer or not.
bool looks_like_cryptomatte(OIIO::string_view name) {
    const auto begins = [](OIIO::string_view rest) {
        size_t letters = 0;
        while (letters < rest.size() && (letter(rest[letters]) || rest[letters] == '_'))
            ++letters;
        return istarts_with(rest, "crypto") && is_rank_of(rest, rest.substr(0, letters));
    };
    for (size_t dot = 0; dot != name.npos; dot = name.find('.', dot + 1))
        if (begins(name.substr(dot > 0 ? dot + 1 : 0)))
            return true;
    return false;
}

/// Whether a channel of that name is a rank of a cryptomatte, of these names or any.
bool is_cryptomatte(const std::string& name, const std::vector<std::string>& layers) {
    return looks_like_cryptomatte(name) ||
           std::any_of(layers.begin(), layers.end(),
                       [&](const std::string& layer) { return is_rank_of(name, layer); });
}

int find_named(const OIIO::ImageSpec& spec, std::initializer_list<const char*> names) {
    for (const char* name : names)
        for (int c = 0; c < spec.nchannels; ++c)
            if (iequals(spec.channel_name(c), name))
                return c;
    return -1;
}

/// Fill in the channels of colour, of those that may be: R, G and B, else the first three, else the
/// one that is named as grey or is alone; or none.
template <class MayBe>
void find_colour(const OIIO::ImageSpec& spec, const MayBe& may_be, ColourLayout& layout) {
    const int named[3] = {find_named(spec, {"R", "red"}), find_named(spec, {"G", "green"}),
                          find_named(spec, {"B", "blue"})};
    if (may_be(named[0]) && may_be(named[1]) && may_be(named[2])) {
        layout.count = 3;
        std::copy(named, named + 3, layout.channel);
        return;
    }
    if (may_be(0) && may_be(1) && may_be(2)) {
        layout.count = 3;
        std::iota(layout.channel, layout.channel + 3, 0);
        return;
    }
    int grey = find_named(spec, {"Y", "L", "I", "luminance", "gray", "grey"});
    if (!may_be(grey)) {
        int candidates = 0;
        for (int c = 0; c < spec.nchannels; ++c)
            if (may_be(c)) {
                grey = c;
                ++candidates;
            }
        if (candidates != 1)
            return;
    }
    layout.count = 1;
    layout.channel[0] = grey;
}

} // namespace

bool is_id_name(OIIO::string_view name) {
    if (!iends_with(name, "id"))
        return false;
    size_t start = name.size() - 1;
    while (start > 0 && letter(name[start - 1]) && !(upper(name[start]) && !upper(name[start - 1])))
        --start;
    // "ID" itself is two capitals: a word that starts at its D starts at its I.
    const OIIO::string_view word = name.substr(std::min(start, name.size() - 2));
    static const char* const english[] = {
        "acid",    "aid",      "amid",        "android",  "arid",      "asteroid",  "avid",
        "avoid",   "bid",      "braid",       "candid",   "cardioid",  "centroid",  "conoid",
        "cuboid",  "cycloid",  "deltoid",     "droid",    "druid",     "ellipsoid", "eyelid",
        "fluid",   "forbid",   "frigid",      "grid",     "helicoid",  "hid",       "humanoid",
        "humid",   "hybrid",   "hyperboloid", "inlaid",   "invalid",   "kid",       "laid",
        "lid",     "liquid",   "lucid",       "maid",     "mermaid",   "mid",       "orchid",
        "ovoid",   "paid",     "paraboloid",  "placid",   "plaid",     "planetoid", "polaroid",
        "pyramid", "raid",     "rapid",       "rhomboid", "rigid",     "said",      "sigmoid",
        "skid",    "solenoid", "solid",       "spheroid", "splendid",  "squid",     "steroid",
        "subgrid", "tabloid",  "toroid",      "torrid",   "trapezoid", "turbid",    "valid",
        "vivid",   "void"};
    return std::none_of(std::begin(english), std::end(english),
                        [&](const char* w) { return iequals(word, w); });
}

bool is_id_type(OIIO::TypeDesc type) {
    return type == OIIO::TypeDesc::UINT32 || type == OIIO::TypeDesc::INT32;
}

int alpha_of(const OIIO::ImageSpec& spec) {
    return spec.alpha_channel < spec.nchannels ? std::max(spec.alpha_channel, -1)
                                               : find_named(spec, {"A", "alpha"});
}

namespace {

/// What stands before a channel's last dot.
std::string layer_of(const std::string& channel) {
    const size_t dot = channel.rfind('.');
    return dot == channel.npos ? "" : channel.substr(0, dot);
}

bool is_any_of(const std::string& name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* other) { return iequals(name, other); });
}

/// As Blender calls objects' and materials' numbers.
bool ends_with_index(const std::string& layer) {
    for (const char* index : {"IndexOB", "IndexMA", "Object Index", "Material Index"})
        if (iends_with(layer, index))
            return true;
    return false;
}

/// Layers of one channel and an ID's name: programs that name every channel by a component write
/// an ID as "objectID.red", Blender as "View.IndexOB.X", later "View.Object Index.X". (Of three,
/// such a layer is a picture of coloured objects; of one called alpha or mask the matte of a thing
/// or person, "david.A".)
std::vector<std::string> layers_of_ids(const OIIO::ImageSpec& spec) {
    std::map<std::string, std::vector<std::string>> components;
    for (const std::string& name : spec.channelnames) {
        const std::string layer = layer_of(name);
        components[layer].push_back(name.substr(layer.empty() ? 0 : layer.size() + 1));
    }
    std::vector<std::string> ids;
    for (const auto& [layer, names] : components)
        if (names.size() == 1 && is_any_of(names.front(), {"r", "red", "x", "v", "value"}) &&
            (is_id_name(layer) || ends_with_index(layer)))
            ids.push_back(layer);
    return ids;
}

} // namespace

Channels channels_of(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& native) {
    const int count = spec.nchannels;
    Channels channels;
    channels.alpha = alpha_of(spec);
    channels.raw = is_id_type(spec.format);
    // A file's channels may each have a type of their own, where the image has one for all.
    const bool same_channels = native.nchannels == count;
    const auto stored_as_id = [&](int c) {
        return channels.raw || is_id_type(same_channels ? native.channelformat(c) : native.format);
    };

    const std::vector<std::string> layers = cryptomattes(spec);
    const std::vector<std::string> ids = layers_of_ids(spec); // in order
    // Of a file's parts each may be a layer, whose channels are R, G, B and A then, or one of any
    // name.
    const std::string part(spec.get_string_attribute("oiio:subimagename"));
    const bool part_of_ids = count == 1 && is_id_name(part);
    for (int c = 0; c < count; ++c) {
        const std::string name = spec.channel_name(c);
        const bool id = stored_as_id(c) || part_of_ids || is_id_name(name) ||
                        std::binary_search(ids.begin(), ids.end(), layer_of(name)) ||
                        is_cryptomatte(name, layers) || is_cryptomatte(part + "." + name, layers);
        channels.kinds.push_back(id                    ? Channel::nearest
                                 : c == channels.alpha ? Channel::alpha
                                                       : Channel::blend);
    }

    const auto blends = [&](int c) {
        return c >= 0 && c < count && c != channels.alpha && channels.kinds[c] == Channel::blend;
    };
    ColourLayout& layout = channels.colour;
    find_colour(
        spec, [&](int c) { return blends(c) && c != spec.z_channel; }, layout);
    for (int c = count - 1; c >= 0; --c)
        if (blends(c))
            channels.guide = c;
    // Readers keep colour unassociated when asked to, and say so.
    if (layout.count && !spec.get_int_attribute("oiio:UnassociatedAlpha"))
        layout.alpha = channels.alpha;
    return channels;
}

} // namespace ddt
