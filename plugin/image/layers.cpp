// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/layers.h"

#include <algorithm>
#include <map>

#include <OpenImageIO/strutil.h>

namespace ddt {

bool is_any_of(OIIO::string_view name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* other) { return OIIO::Strutil::iequals(name, other); });
}

int find_channel(const OIIO::ImageSpec& spec, std::initializer_list<const char*> names) {
    for (const char* name : names)
        for (int c = 0; c < spec.nchannels; ++c)
            if (OIIO::Strutil::iequals(spec.channel_name(c), name))
                return c;
    return -1;
}

std::vector<std::string> pieces_of(const std::string& name) {
    std::vector<std::string> pieces;
    size_t begin = 0;
    for (size_t dot; (dot = name.find('.', begin)) != name.npos; begin = dot + 1)
        pieces.push_back(name.substr(begin, dot - begin));
    pieces.push_back(name.substr(begin));
    return pieces;
}

int Layer::find(std::initializer_list<const char*> names) const {
    for (const char* component : names)
        for (size_t i = 0; i < channels.size(); ++i)
            if (OIIO::Strutil::iequals(components[i], component))
                return channels[i];
    return -1;
}

std::vector<Layer> layers_of(const OIIO::ImageSpec& spec) {
    std::vector<Layer> layers;
    std::map<std::string, size_t> places;
    for (int c = 0; c < spec.nchannels; ++c) {
        const std::string name = spec.channel_name(c);
        const size_t dot = name.rfind('.');
        const std::string before = dot == name.npos ? "" : name.substr(0, dot);
        const auto [at, is_new] = places.emplace(before, layers.size());
        if (is_new)
            layers.push_back({before, {}, {}});
        Layer& layer = layers[at->second];
        layer.channels.push_back(c);
        layer.components.push_back(dot == name.npos ? name : name.substr(dot + 1));
    }
    return layers;
}

} // namespace ddt
