// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/ids/lost_ids.h"

#include <algorithm>
#include <iterator>

#include "plugin/image/channels.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"

namespace ddt::tool {

namespace {

bool has_room(OIIO::TypeDesc from, OIIO::TypeDesc to) {
    if (is_id_type(from))
        return is_id_type(to);
    return to == from ||
           (to.size() > from.size() && (to.is_floating_point() || !from.is_floating_point()));
}

/// Without its level.
std::string compression_of(const OIIO::ImageSpec& spec) {
    const std::string compression = spec.get_string_attribute("compression");
    return compression.substr(0, compression.find(':'));
}

/// Whether a compression of OpenEXR rounds numbers of a channel. DWA does where the last word of
/// its name is that of a colour.
bool rounds(const std::string& compression, OIIO::TypeDesc type, const std::string& channel) {
    if (compression == "pxr24")
        return type == OIIO::TypeFloat;
    if (compression == "b44" || compression == "b44a")
        return type == OIIO::TypeHalf;
    if (compression != "dwaa" && compression != "dwab")
        return false;
    static const char* const colours[] = {"R", "G", "B", "Y", "RY", "BY"};
    return type.is_floating_point() &&
           std::find(std::begin(colours), std::end(colours),
                     channel.substr(channel.rfind('.') + 1)) != std::end(colours);
}

void add(const std::string& name, std::string& names) {
    names += (names.empty() ? "" : ", ") + name;
}

void note_names(const std::string& names, const std::string& path, const std::string& how) {
    if (!names.empty())
        note(format("\"{}\" is written {}, which object IDs do not survive: {}", path, how, names));
}

} // namespace

LostIds lost_ids(const OIIO::ImageSpec& image, const OIIO::ImageSpec& written) {
    const std::string compression = compression_of(written);
    const bool compressed_before = compression == compression_of(image);
    const Channels channels = channels_of(image);
    LostIds lost;
    for (int c = 0; c < std::min(image.nchannels, written.nchannels); ++c) {
        const OIIO::TypeDesc type = written.channelformat(c);
        const std::string name = image.channel_name(c);
        if (channels.kinds[size_t(c)] != Channel::nearest)
            continue;
        if (!has_room(image.channelformat(c), type))
            add(name, lost.by_type);
        else if (!compressed_before && rounds(compression, type, name))
            add(name, lost.by_compression);
    }
    return lost;
}

void note_lost_ids(const OIIO::ImageSpec& image, const OIIO::ImageSpec& written,
                   const std::string& path) {
    const LostIds lost = lost_ids(image, written);
    note_names(lost.by_type, path, format("as {}", written.format.c_str()));
    note_names(lost.by_compression, path,
               format("with the compression {}", compression_of(written)));
}

} // namespace ddt::tool
