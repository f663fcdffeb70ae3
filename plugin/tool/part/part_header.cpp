// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part_header.h"

#include <climits>
#include <string_view>

#include <OpenImageIO/strutil.h>

#include "core/base/parse_number.h"
#include "plugin/image/largest_side.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"
#include "plugin/tool/file/metadata_text.h"

namespace ddt::tool {

namespace {

// Not "ddt:": OpenImageIO writes no metadata that begin with the name of another format, which
// "ddt" is where the plugin's reader is.
constexpr const char* job_key = "ddt_part:job";
constexpr const char* part_key = "ddt_part:part";
constexpr const char* whole_key = "ddt_part:whole";
constexpr const char* type_key = "ddt_part:type";
constexpr const char* tiles_key = "ddt_part:tiles";       // not there: none
constexpr const char* channels_key = "ddt_part:channels"; // a line each
constexpr const char* metadata_key = "ddt_part:metadata";

/// Whether it is the name of a kind of number.
bool is_number_type(const std::string& name) {
    const OIIO::TypeDesc type(name);
    return stored_type(type) != OIIO::TypeUnknown &&
           type == OIIO::TypeDesc(OIIO::TypeDesc::BASETYPE(type.basetype));
}

bool parse_int(std::string_view text, int& number) {
    return parse_number(text, INT_MIN, INT_MAX, number);
}

/// Four numbers and nothing else: a file may be anyone's.
bool parse_window(const std::string& text, Rect& window) {
    const std::vector<OIIO::string_view> words = OIIO::Strutil::splitsv(text, " ");
    return words.size() == 4 && parse_int(words[0], window.x0) && parse_int(words[1], window.y0) &&
           parse_int(words[2], window.x1) && parse_int(words[3], window.y1);
}

} // namespace

OIIO::TypeDesc stored_type(OIIO::TypeDesc type) {
    switch (type.basetype) {
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::UINT32:
        return type;
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
        return OIIO::TypeHalf;
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
        return OIIO::TypeFloat;
    default:
        return OIIO::TypeUnknown;
    }
}

bool is_kept_name(const std::string& channel) {
    return channel.find('\n') == std::string::npos;
}

PartHeader header_of(const std::string& job, const Part& part, const OIIO::ImageSpec& whole) {
    PartHeader header;
    header.job = job;
    header.part = part;
    header.whole = rect_of(OIIO::get_roi(whole));
    header.type = whole.format.c_str();
    header.tile_width = whole.tile_width;
    header.tile_height = whole.tile_height;
    header.channels = whole.channelnames;
    header.metadata = whole.extra_attribs;
    return header;
}

void PartHeader::write_to(OIIO::ImageSpec& spec) const {
    spec.attribute(job_key, job);
    spec.attribute(part_key, format("{}/{}", part.index, part.count));
    spec.attribute(whole_key, format("{} {} {} {}", whole.x0, whole.y0, whole.x1, whole.y1));
    spec.attribute(type_key, type);
    if (tile_width > 0)
        spec.attribute(tiles_key, format("{}x{}", tile_width, tile_height));
    spec.attribute(channels_key, OIIO::Strutil::join(channels, "\n"));
    spec.attribute(metadata_key, text_of(metadata));
}

bool PartHeader::read_from(const OIIO::ImageSpec& spec) {
    job = spec.get_string_attribute(job_key);
    type = spec.get_string_attribute(type_key);
    const std::string names = spec.get_string_attribute(channels_key);
    channels = names.empty() ? std::vector<std::string>() : OIIO::Strutil::splits(names, "\n");
    tile_width = tile_height = 0;
    parse_sides(spec.get_string_attribute(tiles_key), 1, largest_side, tile_width, tile_height);
    return !job.empty() && spec.tile_width >= 1 &&
           parse_part(spec.get_string_attribute(part_key), part) &&
           parse_window(spec.get_string_attribute(whole_key), whole) && !whole.empty() &&
           is_number_type(type) && metadata_of(spec.get_string_attribute(metadata_key), metadata);
}

} // namespace ddt::tool
