// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/fingerprint.h"

#include <algorithm>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/hash.h>
#include <OpenImageIO/strutil.h>

#include "ddt/option_table.h"
#include "plugin/colour/space_light.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

/// What the config that is in use makes of numbers, and how edges are sought in them.
std::vector<float> light_of(const std::string& option, const std::string& space) {
    std::string ignored; // resizing tells
    const auto light = find_light(option, space, ignored);
    if (!light)
        return {};
    std::vector<float> all(light->luma().begin(), light->luma().end());
    all.push_back(float(light->known()));
    all.push_back(float(light->converts()));
    if (!light->converts() || option == "encoded")
        return all;
    std::vector<float> ramp;
    for (int i = -8; i <= 64; ++i)
        for (int c = 0; c < 3; ++c)
            ramp.push_back(float(i + c) / 32);
    light->to_light(ramp.data(), ramp.size() / 3);
    all.insert(all.end(), ramp.begin(), ramp.end());
    return all;
}

constexpr uint64_t pieces = 1024;
constexpr size_t piece = size_t(64) << 10;

} // namespace

std::string fingerprint(const std::string& source, const OIIO::ImageSpec& source_spec,
                        const OIIO::ImageSpec& result, const ResizeSettings& settings) {
    OIIO::SHA1 hash;
    const auto add = [&](const std::string& text) { hash.append(text.data(), text.size() + 1); };
    const auto windows = [&](const OIIO::ImageSpec& s) {
        add(format("{} {} {} {} {} {} {} {} {} {}", s.x, s.y, s.width, s.height, s.full_x, s.full_y,
                   s.full_width, s.full_height, s.nchannels, s.format));
    };
    add(DDT_VERSION);
    add(std::to_string(int(settings.options.surface.kind)));
    for (const Option& option : option_table())
        if (option.group != OptionGroup::device) // which gives the same bits
            add(option.key + ("=" + option.get(settings.options)));
    windows(source_spec);
    windows(result);
    // Without --type some may have another than the widest, which is that of all with it.
    for (const OIIO::TypeDesc& type : result.channelformats)
        add(type.c_str());
    add(result.get_string_attribute("compression"));
    for (const std::string& channel : source_spec.channelnames)
        add(channel);
    const std::string space = source_spec.get_string_attribute("oiio:ColorSpace");
    add(space);
    const std::vector<float> light = light_of(settings.options.light, space);
    hash.append(light.data(), light.size() * sizeof(float));

    const uint64_t size = OIIO::Filesystem::file_size(source);
    add(std::to_string(size));
    OIIO::Filesystem::IOFile file(source, OIIO::Filesystem::IOProxy::Read);
    if (!file.opened())
        return {};
    std::vector<char> bytes(piece);
    const uint64_t count = std::min((size + piece - 1) / piece, pieces);
    const uint64_t last = size > piece ? size - piece : 0;
    for (uint64_t i = 0; i < count; ++i)
        hash.append(bytes.data(), file.pread(bytes.data(), piece,
                                             int64_t(count > 1 ? last * i / (count - 1) : 0)));
    return hash.digest();
}

} // namespace ddt::tool
