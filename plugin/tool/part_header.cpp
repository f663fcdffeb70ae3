// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part_header.h"

#include <cstdio>

#include <OpenImageIO/strutil.h>

#include "core/base/parse_number.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

// Not "ddt:": OpenImageIO writes no metadata that begin with the name of another format, which
// "ddt" is where the plugin's reader is.
constexpr const char* job_key = "ddt_part:job";
constexpr const char* part_key = "ddt_part:part";
constexpr const char* whole_key = "ddt_part:whole";
constexpr const char* type_key = "ddt_part:type";
constexpr const char* space_key = "ddt_part:colorspace";
constexpr const char* compression_key = "ddt_part:compression";
constexpr const char* channels_key = "ddt_part:channels"; // a line each
constexpr const char* date_key = "ddt_part:date";
constexpr const char* profile_key = "ddt_part:profile"; // as text: EXR files hold no bytes
constexpr const char* bits_key = "ddt_part:bits";
constexpr const char* aspect_key = "ddt_part:noaspect";

/// Whether it is the name of a kind of number.
bool is_number_type(const std::string& name) {
    const OIIO::TypeDesc type(name);
    return stored_type(type) != OIIO::TypeUnknown &&
           type == OIIO::TypeDesc(OIIO::TypeDesc::BASETYPE(type.basetype));
}

std::string hex(const std::vector<unsigned char>& bytes) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

/// Nothing for a text that is not of hex().
std::vector<unsigned char> bytes_of(const std::string& hex) {
    if (hex.size() % 2 != 0 || hex.find_first_not_of("0123456789abcdef") != std::string::npos)
        return {};
    std::vector<unsigned char> bytes;
    for (size_t i = 0; i < hex.size(); i += 2)
        bytes.push_back((unsigned char)(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}

std::vector<unsigned char> profile_of(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const found = spec.find_attribute("ICCProfile");
    if (!found || found->type().basetype != OIIO::TypeDesc::UINT8)
        return {};
    const auto* const data = static_cast<const unsigned char*>(found->data());
    return {data, data + found->datasize()};
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

PartHeader header_of(const std::string& job, const Part& part, const OIIO::ImageSpec& whole) {
    PartHeader header;
    header.job = job;
    header.part = part;
    header.whole = rect_of(OIIO::get_roi(whole));
    header.type = whole.format.c_str();
    header.colour_space = whole.get_string_attribute("oiio:ColorSpace");
    header.compression = whole.get_string_attribute("compression");
    header.channels = whole.channelnames;
    header.date = whole.get_string_attribute("DateTime");
    header.profile = profile_of(whole);
    header.bits = whole.get_int_attribute("oiio:BitsPerSample");
    header.no_aspect = !whole.find_attribute("PixelAspectRatio");
    return header;
}

void PartHeader::write_to(OIIO::ImageSpec& spec) const {
    spec.attribute(job_key, job);
    spec.attribute(part_key, format("{}/{}", part.index, part.count));
    spec.attribute(whole_key, format("{} {} {} {}", whole.x0, whole.y0, whole.x1, whole.y1));
    spec.attribute(type_key, type);
    spec.attribute(space_key, colour_space);
    spec.attribute(compression_key, compression);
    spec.attribute(channels_key, OIIO::Strutil::join(channels, "\n"));
    spec.attribute(date_key, date);
    spec.attribute(profile_key, hex(profile));
    spec.attribute(bits_key, std::to_string(bits));
    if (no_aspect)
        spec.attribute(aspect_key, "1");
}

bool PartHeader::take_from(OIIO::ImageSpec& spec) {
    job = spec.get_string_attribute(job_key);
    type = spec.get_string_attribute(type_key);
    colour_space = spec.get_string_attribute(space_key);
    compression = spec.get_string_attribute(compression_key);
    const std::string names = spec.get_string_attribute(channels_key);
    channels = names.empty() ? std::vector<std::string>() : OIIO::Strutil::splits(names, "\n");
    date = spec.get_string_attribute(date_key);
    profile = bytes_of(spec.get_string_attribute(profile_key));
    bits = 0;
    parse_number(std::string(spec.get_string_attribute(bits_key)), 0, 64, bits);
    no_aspect = spec.get_string_attribute(aspect_key) == "1";
    const std::string window = spec.get_string_attribute(whole_key);
    if (job.empty() || spec.tile_width < 1 ||
        !parse_part(spec.get_string_attribute(part_key), part) ||
        std::sscanf(window.c_str(), "%d %d %d %d", &whole.x0, &whole.y0, &whole.x1, &whole.y1) !=
            4 ||
        whole.empty() || !is_number_type(type))
        return false;
    for (const char* key : {job_key, part_key, whole_key, type_key, space_key, compression_key,
                            channels_key, date_key, profile_key, bits_key, aspect_key})
        spec.erase_attribute(key);
    return true;
}

} // namespace ddt::tool
