// SPDX-License-Identifier: Apache-2.0
// The Polygon File Format ("PLY"; Turk 1994) as far as points and polygons go.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>

#include <OpenImageIO/strutil.h>

#include "plugin/message/format.h"
#include "plugin/tool/points/ply_types.h"
#include "plugin/tool/points/point_file.h"
#include "plugin/tool/points/polygons.h"

namespace ddt::tool {

namespace {

struct Property {
    std::string name;
    const PlyType* number = nullptr;
    const PlyType* length = nullptr; ///< of a list, else null
};
struct Element {
    std::string name;
    size_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { text, little, big };

/// Takes numbers off a file's body.
class Body {
public:
    Body(const std::string& text, size_t at, Encoding encoding)
        : m_text(text), m_at(at), m_encoding(encoding) {}

    /// The next number; none at the end, or where there is something else.
    std::optional<double> next(const PlyType& as) {
        return m_encoding == Encoding::text ? next_word(as) : next_bytes(as);
    }

private:
    std::optional<double> next_word(const PlyType& as) {
        const char* blanks = " \t\r\n";
        m_at = std::min(m_text.find_first_not_of(blanks, m_at), m_text.size());
        const size_t end = std::min(m_text.find_first_of(blanks, m_at), m_text.size());
        const std::optional<double> v = number_in(m_text.substr(m_at, end - m_at));
        m_at = end;
        return v && has_room(as, *v) ? v : std::nullopt;
    }
    template <class T>
    static double as_number(const unsigned char* bytes) {
        T v;
        std::memcpy(&v, bytes, sizeof v);
        return double(v);
    }
    std::optional<double> next_bytes(const PlyType& as) {
        if (m_text.size() - m_at < as.bytes)
            return {};
        const bool swap = (m_encoding == Encoding::big) == OIIO::littleendian();
        unsigned char bytes[8];
        for (size_t k = 0; k < as.bytes; ++k)
            bytes[swap ? as.bytes - 1 - k : k] = static_cast<unsigned char>(m_text[m_at + k]);
        m_at += as.bytes;
        switch (as.number) {
        case PlyNumber::int8:
            return as_number<int8_t>(bytes);
        case PlyNumber::uint8:
            return as_number<uint8_t>(bytes);
        case PlyNumber::int16:
            return as_number<int16_t>(bytes);
        case PlyNumber::uint16:
            return as_number<uint16_t>(bytes);
        case PlyNumber::int32:
            return as_number<int32_t>(bytes);
        case PlyNumber::uint32:
            return as_number<uint32_t>(bytes);
        case PlyNumber::float32:
            return as_number<float>(bytes);
        case PlyNumber::float64:
            return as_number<double>(bytes);
        }
        return {};
    }

    const std::string& m_text;
    size_t m_at;
    const Encoding m_encoding;
};

class PlyReader {
public:
    PlyReader(const std::string& text, PointFile& points) : m_text(text), m_points(points) {}

    bool read(std::string& error) {
        if (!read_header() || !read_body()) {
            error = m_error;
            return false;
        }
        mend_fans(m_points);
        return true;
    }

private:
    bool wrong(std::string why) {
        m_error = std::move(why);
        return false;
    }
    bool wrong_line(const std::string& line) {
        return wrong("not a line of a PLY header: \"" + line.substr(0, 60) + "\"");
    }

    bool next_line(std::string& line) {
        const size_t end = m_text.find('\n', m_at);
        if (end == std::string::npos)
            return false;
        line = m_text.substr(m_at, end - m_at);
        if (!line.empty() && line.back() == '\r')
            line.pop_back();
        m_at = end + 1;
        return true;
    }

    bool read_header() {
        std::string line;
        if (!next_line(line) || line != "ply")
            return wrong("not a PLY file: it does not begin with \"ply\"");
        while (next_line(line)) {
            std::istringstream words(line);
            std::string word;
            words >> word;
            if (word == "end_header")
                return m_has_format || wrong("the PLY header has no line \"format\"");
            if (word == "format"     ? !read_format(words)
                : word == "element"  ? !read_element(words)
                : word == "property" ? !read_property(words)
                                     : word != "comment" && word != "obj_info" && !word.empty())
                return wrong_line(line);
        }
        return wrong("the PLY header has no end");
    }
    bool read_format(std::istringstream& words) {
        std::string name, version;
        words >> name >> version;
        m_has_format = version == "1.0";
        m_encoding = name == "ascii"                  ? Encoding::text
                     : name == "binary_little_endian" ? Encoding::little
                                                      : Encoding::big;
        return m_has_format && (m_encoding != Encoding::big || name == "binary_big_endian");
    }
    bool read_element(std::istringstream& words) {
        Element element;
        std::string count;
        words >> element.name >> count;
        const char* const end = count.data() + count.size();
        const auto read = std::from_chars(count.data(), end, element.count); // takes no sign
        m_elements.push_back(element);
        return read.ec == std::errc() && read.ptr == end;
    }
    bool read_property(std::istringstream& words) {
        std::string type, name;
        Property property;
        words >> type;
        if (type == "list") {
            words >> type;
            property.length = find_ply_type(type);
            if (!property.length)
                return false;
            words >> type;
        }
        property.number = find_ply_type(type);
        words >> property.name;
        if (!property.number || words.fail() || m_elements.empty())
            return false;
        m_elements.back().properties.push_back(property);
        return true;
    }

    bool read_body() {
        Body body(m_text, m_at, m_encoding);
        for (const Element& element : m_elements) {
            // Every element takes a byte at least: a count beyond that is not believed.
            if (element.properties.empty())
                continue;
            if (element.count > m_text.size())
                return wrong("the file ends before its " + element.name + " elements do");
            if (element.name == "vertex" && !prepare_points(element))
                return false;
            for (m_item = 0; m_item < element.count; ++m_item)
                for (size_t p = 0; p < element.properties.size(); ++p)
                    if (!read_value(body, element, p))
                        return m_error.empty()
                                   ? wrong(format("{} {} ends too early or holds what is no number "
                                                  "of its type",
                                                  element.name, m_item))
                                   : false;
        }
        return m_points.mesh.x.empty() ? wrong("there are no points") : true;
    }

    bool prepare_points(const Element& element) {
        if (element.count > most_points)
            return wrong(
                format("{} points are too many; allowed are {}", element.count, most_points));
        const auto count = [&](const char* name) {
            return std::count_if(element.properties.begin(), element.properties.end(),
                                 [&](const Property& p) { return p.name == name; });
        };
        if (!m_target.empty() || count("x") != 1 || count("y") != 1)
            return wrong("there must be one element vertex, with one x and one y");
        m_target.assign(element.properties.size(), nullptr);
        m_points.columns.reserve(element.properties.size());
        for (const Property& p : element.properties) {
            if (p.length)
                return wrong("a vertex has a list, " + p.name);
            if (p.name == "x" || p.name == "y") {
                auto& axis = p.name == "x" ? m_points.mesh.x : m_points.mesh.y;
                axis.reserve(element.count);
                continue;
            }
            Column column{p.name, p.number->name, 1, {}};
            const bool colour = column.is_colour() || column.is_alpha();
            if (colour && p.number->number == PlyNumber::uint8)
                column.scale = 255;
            if (colour && p.number->number == PlyNumber::uint16)
                column.scale = 65535;
            column.values.reserve(element.count);
            m_points.columns.push_back(std::move(column));
        }
        size_t next = 0;
        for (size_t p = 0; p < element.properties.size(); ++p)
            if (element.properties[p].name != "x" && element.properties[p].name != "y")
                m_target[p] = &m_points.columns[next++];
        return true;
    }

    bool read_value(Body& body, const Element& element, size_t p) {
        const Property& property = element.properties[p];
        if (property.length)
            return read_list(body, property,
                             element.name == "face" && (property.name == "vertex_indices" ||
                                                        property.name == "vertex_index"));
        const auto v = body.next(*property.number);
        if (!v)
            return false;
        if (element.name != "vertex")
            return true;
        if (Column* column = m_target[p]) {
            column->values.push_back(*v / column->scale);
            return true;
        }
        auto& axis = property.name == "x" ? m_points.mesh.x : m_points.mesh.y;
        axis.push_back(*v);
        return std::isfinite(*v) ||
               wrong(format("vertex {} has a position that is not finite", axis.size() - 1));
    }

    bool read_list(Body& body, const Property& property, bool corners) {
        const auto length = body.next(*property.length);
        if (!length || !(*length >= 0) || *length > double(m_text.size()))
            return false;
        std::vector<int32_t> list;
        for (size_t i = 0; i < size_t(*length); ++i) {
            const auto v = body.next(*property.number);
            if (!v)
                return false;
            if (corners && !(*v >= 0 && *v < double(most_points) && *v == std::floor(*v)))
                return wrong(format("face {} has a vertex that there is not", m_item));
            if (corners)
                list.push_back(int32_t(*v));
        }
        for (size_t i = 2; i < list.size(); ++i) {
            m_points.mesh.triangles.push_back({list[0], list[i - 1], list[i]});
            m_points.faces.push_back(uint32_t(m_item));
        }
        return true;
    }

    const std::string& m_text;
    PointFile& m_points;
    size_t m_at = 0;
    size_t m_item = 0; ///< of the element that is read
    Encoding m_encoding = Encoding::text;
    bool m_has_format = false;
    std::vector<Element> m_elements;
    std::vector<Column*> m_target; ///< where a vertex's properties go; null: x or y
    std::string m_error;
};

} // namespace

bool read_ply(const std::string& text, PointFile& points, std::string& error) {
    points = {};
    return PlyReader(text, points).read(error);
}

} // namespace ddt::tool
