// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part_file.h"

#include <algorithm>
#include <climits>
#include <cstring>

#include <OpenImageIO/strutil.h>

#include "plugin/message/format.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/reading_errors.h"

namespace ddt::tool {

namespace {

bool cannot_read(const PartFile& part, Failure& failure) {
    std::string why = part.input ? part.input->geterror() : OIIO::geterror();
    if (const std::string denied = why_not_opened(part.path); !denied.empty())
        why = denied;
    why = std::string(OIIO::Strutil::strip(why.substr(0, why.find('\n'))));
    failure = unreadable(part.path,
                         "cannot read \"" + part.path + "\"" + (why.empty() ? "" : ": " + why));
    return part.state.confirm(false, failure);
}

bool is_allowed(const Rect& r) {
    return !r.empty() && r.within_limits();
}

/// Bring the channels of part.spec, which a file sorts by name, into the whole's order.
bool order_channels(PartFile& part, Failure& failure) {
    OIIO::ImageSpec& spec = part.spec;
    const std::vector<std::string>& names = part.header.channels;
    if (names.empty() || names == spec.channelnames)
        return true;
    const OIIO::ImageSpec file = spec;
    if (!std::is_permutation(names.begin(), names.end(), file.channelnames.begin(),
                             file.channelnames.end())) {
        failure = {"\"" + part.path + "\" has other channels than it was written with"};
        return false;
    }
    for (int i = 0; i < file.nchannels; ++i) {
        const int place = file.channelindex(names[size_t(i)]);
        part.places.push_back(place);
        if (!file.channelformats.empty())
            spec.channelformats[size_t(i)] = file.channelformat(place);
        if (place == file.alpha_channel)
            spec.alpha_channel = i;
        if (place == file.z_channel)
            spec.z_channel = i;
    }
    spec.channelnames = names;
    return true;
}

/// Bytes of a pixel as it was read that are one channel.
struct Piece {
    size_t offset = 0, size = 0;
};

/// In the whole's order; empty where it is the file's.
std::vector<Piece> pieces_of(const PartFile& part, OIIO::TypeDesc type) {
    const std::vector<int>& places = part.places;
    std::vector<Piece> pieces(places.size());
    for (size_t c = 0; c < places.size(); ++c)
        pieces[c].size =
            (type == OIIO::TypeUnknown ? part.spec.channelformat(int(c)) : type).size();
    for (size_t c = 0; c < places.size(); ++c)
        for (size_t k = 0; k < places.size(); ++k)
            if (places[k] < places[c])
                pieces[c].offset += pieces[k].size;
    return pieces;
}

/// The channels of pixels as read into the whole's order.
void move_channels(const std::vector<Piece>& pieces, size_t pixel, std::vector<char>& pixels) {
    std::vector<char> one(pixel);
    for (size_t at = 0; !pieces.empty() && at < pixels.size(); at += pixel) {
        std::memcpy(one.data(), &pixels[at], pixel);
        size_t to = at;
        for (const Piece& piece : pieces) {
            std::memcpy(&pixels[to], &one[piece.offset], piece.size);
            to += piece.size;
        }
    }
}

} // namespace

bool read_header(PartFile& part, Failure& failure) {
    if (!check_reader(part.path, 0, failure))
        return false;
    part.input = OIIO::ImageInput::open(part.path);
    if (!part.input)
        return cannot_read(part, failure);
    OIIO::ImageSpec& spec = part.spec;
    spec = part.input->spec();
    part.input.reset();
    if (spec.depth > 1 || spec.tile_depth > 1 || spec.deep || !part.header.read_from(spec)) {
        failure = {"\"" + part.path + "\" is no part; allowed are files of ddt resize --part"};
        return false;
    }
    if (!order_channels(part, failure))
        return false;
    const auto end = [](int first, int size) {
        return int(std::min(int64_t(first) + size, int64_t(INT_MAX)));
    };
    part.window = {spec.x, spec.y, end(spec.x, spec.width), end(spec.y, spec.height)};
    if (is_allowed(part.window) && is_allowed(part.header.whole))
        return true;
    failure = {format("\"{}\" has a window whose coordinates are not within +-{}", part.path,
                      largest_coordinate)};
    return false;
}

bool load(PartFile& part, int y, const Held& held, Failure& failure) {
    if (!part.input) {
        part.input = OIIO::ImageInput::open(part.path);
        if (!part.input)
            return cannot_read(part, failure);
        // Of another file the header would be another: rows have room for what was planned.
        if (!part.state.confirm(true, failure))
            return false;
    }
    const OIIO::ImageSpec& spec = part.input->spec();
    const int height = spec.tile_height;
    part.y0 = part.window.y0 + (y - part.window.y0) / height * height;
    part.y1 = part.y0 + std::min(height, part.window.y1 - part.y0);
    part.tiles.resize(held.pixel * size_t(part.window.width()) * size_t(height));
    if (!part.input->read_tiles(0, 0, part.window.x0, part.window.x1, part.y0, part.y1, 0, 1, 0,
                                spec.nchannels, held.type, part.tiles.data()))
        return cannot_read(part, failure);
    move_channels(pieces_of(part, held.type), held.pixel, part.tiles);
    return true;
}

} // namespace ddt::tool
