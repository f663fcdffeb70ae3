// SPDX-License-Identifier: Apache-2.0
// A line is: the name, the type's four numbers, how many values of it there are, and the values'
// bytes; the first and the last as hexadecimal digits. Texts among the values end with a byte of 0.
#include "plugin/tool/file/metadata_text.h"

#include <climits>
#include <string_view>
#include <vector>

#include <OpenImageIO/strutil.h>

#include "core/base/parse_number.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

using OIIO::TypeDesc;

std::string hex(std::string_view bytes) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    text.reserve(2 * bytes.size());
    for (const char c : bytes) {
        const auto byte = (unsigned char)(c);
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

/// False for a text that is not of hex().
bool bytes_of(std::string_view hex, std::string& bytes) {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
    };
    bytes.clear();
    for (size_t i = 0; i + 1 < hex.size(); i += 2) {
        const int high = digit(hex[i]), low = digit(hex[i + 1]);
        if (high < 0 || low < 0)
            return false;
        bytes += char(high << 4 | low);
    }
    return hex.size() % 2 == 0;
}

/// The values of one attribute: texts one after the other, each with its 0.
std::string bytes_of(const OIIO::ParamValue& attribute) {
    if (attribute.type().basetype != TypeDesc::STRING)
        return {static_cast<const char*>(attribute.data()), size_t(attribute.datasize())};
    std::string bytes;
    const auto* const texts = static_cast<const OIIO::ustring*>(attribute.data());
    const size_t count = size_t(attribute.nvalues()) * attribute.type().numelements() *
                         size_t(attribute.type().aggregate);
    for (size_t i = 0; i < count; ++i) {
        bytes += texts[i].c_str() ? texts[i].c_str() : "";
        bytes += '\0';
    }
    return bytes;
}

bool is_carried(const OIIO::ParamValue& attribute) {
    const TypeDesc type = attribute.type();
    return type.basetype > TypeDesc::NONE && type.basetype <= TypeDesc::STRING &&
           type.arraylen >= 0 && attribute.nvalues() > 0 && attribute.data();
}

/// Of which OpenImageIO knows the names: it ends a process that asks it for another's.
bool is_known(int aggregate, int semantics) {
    switch (aggregate) {
    case TypeDesc::SCALAR:
    case TypeDesc::VEC2:
    case TypeDesc::VEC3:
    case TypeDesc::VEC4:
    case TypeDesc::MATRIX33:
    case TypeDesc::MATRIX44:
        return semantics >= TypeDesc::NOSEMANTICS && semantics <= TypeDesc::BOX;
    default:
        return false;
    }
}

/// The type and the number of values that five numbers stand for. False where they are none, or the
/// values could not be `bytes` long, texts included.
bool parse_type(const std::vector<OIIO::string_view>& numbers, size_t bytes, TypeDesc& type,
                int& values) {
    int base = 0, aggregate = 0, semantics = 0, length = 0;
    if (!parse_number<int>(numbers[0], TypeDesc::NONE + 1, TypeDesc::STRING, base) ||
        !parse_number(numbers[1], 0, INT_MAX, aggregate) ||
        !parse_number(numbers[2], 0, INT_MAX, semantics) || !is_known(aggregate, semantics) ||
        !parse_number(numbers[3], 0, INT_MAX, length) ||
        !parse_number(numbers[4], 1, INT_MAX, values))
        return false;
    type = TypeDesc(TypeDesc::BASETYPE(base), TypeDesc::AGGREGATE(aggregate),
                    TypeDesc::VECSEMANTICS(semantics), length);
    return type.numelements() <= bytes && size_t(values) <= bytes / type.numelements();
}

/// The values whose bytes those are; false if they are not as many.
bool take_values(OIIO::string_view name, TypeDesc type, int values, const std::string& bytes,
                 OIIO::ParamValueList& metadata) {
    if (type.basetype != TypeDesc::STRING) {
        if (bytes.size() != size_t(values) * type.size())
            return false;
        metadata.push_back(OIIO::ParamValue(name, type, values, bytes.data()));
        return true;
    }
    std::vector<OIIO::ustring> texts;
    for (size_t at = 0; at < bytes.size(); at += texts.back().size() + 1)
        texts.emplace_back(bytes.c_str() + at);
    if (bytes.back() != '\0' ||
        texts.size() != size_t(values) * type.numelements() * size_t(type.aggregate))
        return false;
    metadata.push_back(OIIO::ParamValue(name, type, values, texts.data()));
    return true;
}

bool take_line(OIIO::string_view line, OIIO::ParamValueList& metadata) {
    const std::vector<OIIO::string_view> words = OIIO::Strutil::splitsv(line, " ");
    std::string name, bytes;
    TypeDesc type;
    int values = 0;
    return words.size() == 7 && bytes_of(words[0], name) && !name.empty() &&
           bytes_of(words[6], bytes) && !bytes.empty() &&
           parse_type({words.begin() + 1, words.begin() + 6}, bytes.size(), type, values) &&
           take_values(name, type, values, bytes, metadata);
}

} // namespace

std::string text_of(const OIIO::ParamValueList& metadata) {
    std::string text;
    for (const OIIO::ParamValue& attribute : metadata) {
        if (!is_carried(attribute))
            continue;
        const TypeDesc type = attribute.type();
        text += format("{} {} {} {} {} {} {}\n", hex(attribute.name().string()), int(type.basetype),
                       int(type.aggregate), int(type.vecsemantics), type.arraylen,
                       attribute.nvalues(), hex(bytes_of(attribute)));
    }
    return text;
}

bool metadata_of(const std::string& text, OIIO::ParamValueList& metadata) {
    metadata.clear();
    for (const OIIO::string_view& line : OIIO::Strutil::splitsv(text, "\n"))
        if (!line.empty() && !take_line(line, metadata)) {
            metadata.clear();
            return false;
        }
    return true;
}

} // namespace ddt::tool
