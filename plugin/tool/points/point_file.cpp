// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/point_file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <fcntl.h>
#include <unistd.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "plugin/message/format.h"
#include "plugin/tool/file/file_state.h"

namespace ddt::tool {

namespace {

/// Appends numbers in little endian order, whatever the machine's is.
class Bytes {
public:
    template <class Word>
    void word(Word v) {
        for (size_t k = 0; k < sizeof v; ++k)
            m_bytes += char(uint64_t(v) >> (8 * k) & 0xff);
    }
    void number(double v) {
        uint64_t bits;
        std::memcpy(&bits, &v, sizeof bits);
        word(bits);
    }
    void number(float v) {
        uint32_t bits;
        std::memcpy(&bits, &v, sizeof bits);
        word(bits);
    }
    const std::string& text() const { return m_bytes; }

private:
    std::string m_bytes;
};

/// The nearest whole number that the type holds.
template <class Whole>
Whole nearest(double v) {
    using Limits = std::numeric_limits<Whole>;
    return v > double(Limits::min()) ? Whole(std::min(std::floor(v + 0.5), double(Limits::max())))
           : v < 0                   ? Limits::min()
                                     : Whole(0);
}

void put(const Column& column, size_t point, Bytes& to) {
    const double v = column.values[point] * column.scale;
    const std::string& type = column.type;
    if (type == "char")
        to.word(nearest<int8_t>(v));
    else if (type == "uchar")
        to.word(nearest<uint8_t>(v));
    else if (type == "short")
        to.word(nearest<int16_t>(v));
    else if (type == "ushort")
        to.word(nearest<uint16_t>(v));
    else if (type == "int")
        to.word(nearest<int32_t>(v));
    else if (type == "uint")
        to.word(nearest<uint32_t>(v));
    else if (type == "double")
        to.number(v);
    else
        to.number(float(v));
}

/// A name as PLY has them: one word.
std::string written_name(const Column& column) {
    std::string name = column.name.empty() ? "unnamed" : column.name;
    for (char& c : name)
        if ((unsigned char)(c) <= ' ')
            c = '_';
    return name;
}

/// Whether a file is a device that has no end, as far as one can tell: one that is no terminal.
bool is_endless(const std::string& path) {
    if (std::error_code ignored; !std::filesystem::is_character_file(path, ignored))
        return false;
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    const bool endless = descriptor >= 0 && !isatty(descriptor);
    if (descriptor >= 0)
        close(descriptor);
    return endless;
}

/// The bytes of a file. False with errno if they cannot be read.
bool read_bytes(const std::string& path, std::string& bytes) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    try {
        bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    } catch (const std::ios_base::failure&) { // a folder: whatever the stream was asked for
        return false;
    }
    return file.good() || file.eof();
}

} // namespace

std::optional<double> number_in(const std::string& word) {
    char* end = nullptr;
    const double number = word.empty() ? 0 : OIIO::Strutil::strtod(word.c_str(), &end);
    if (word.empty() || end != word.c_str() + word.size())
        return {};
    return number;
}

const Column* PointFile::find(const std::string& name) const {
    for (const Column& column : columns)
        if (column.name == name)
            return &column;
    return nullptr;
}

const Column* PointFile::find_meant(const std::string& name) const {
    if (const Column* column = find(name))
        return column;
    for (const Column& column : columns)
        if (OIIO::Strutil::iequals(column.name, name))
            return &column;
    for (const auto& [colour, letter] : colour_columns)
        if (OIIO::Strutil::iequals(name, letter))
            return find(colour);
    return nullptr;
}

namespace {

bool read_once(const std::string& path, PointFile& points, Failure& failure) {
    if (is_endless(path)) {
        failure = {"\"" + path + "\": it is a device; allowed are files, pipes and terminals"};
        return false;
    }
    std::string text;
    if (!read_bytes(path, text)) {
        const int number = errno ? errno : EIO;
        failure = {"\"" + path + "\": " + std::strerror(number), code_of_errno(number)};
        return false;
    }
    const std::string extension = OIIO::Strutil::lower(OIIO::Filesystem::extension(path));
    std::string error;
    const bool ply = extension == ".ply" || text.compare(0, 4, "ply\n") == 0 ||
                     text.compare(0, 5, "ply\r\n") == 0;
    if (ply ? read_ply(text, points, error) : read_table(text, points, error))
        return true;
    failure = {"\"" + path + "\": " + error, exit_failed};
    return false;
}

} // namespace

bool read_points(const std::string& path, PointFile& points, Failure& failure) {
    const FileState before(path);
    return before.confirm(read_once(path, points, failure), failure);
}

std::string fault_in(const std::string& path, const PointFile& points, const std::string& why) {
    const auto begins = [&](const char* text) { return OIIO::Strutil::starts_with(why, text); };
    if (!begins("ddt: triangle") && !begins("ddt: the points"))
        return why;
    unsigned long triangle = 0;
    int end = 0;
    const std::string name = "\"" + path + "\": ";
    if (std::sscanf(why.c_str(), "ddt: triangle %lu%n", &triangle, &end) == 1 &&
        triangle < points.faces.size())
        return name + format("face {}", points.faces[triangle]) + why.substr(size_t(end));
    return name + why.substr(std::strlen("ddt: "));
}

bool write_points(const std::string& path, const PointFile& points, Failure& failure) {
    WholeFile file;
    return file.open(path, failure) && write_points(file, points, failure) && file.commit(failure);
}

bool write_points(WholeFile& file, const PointFile& points, Failure& failure) {
    const size_t count = points.mesh.x.size();
    std::string header = format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
                                "property double x\nproperty double y\n",
                                count);
    for (const Column& column : points.columns)
        header += format("property {} {}\n", column.type, written_name(column));
    header += format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                     points.mesh.triangles.size());
    Bytes bytes;
    for (size_t i = 0; i < count; ++i) {
        bytes.number(points.mesh.x[i]);
        bytes.number(points.mesh.y[i]);
        for (const Column& column : points.columns)
            put(column, i, bytes);
    }
    for (const auto& t : points.mesh.triangles) {
        bytes.word(uint8_t(3));
        for (const int32_t v : t)
            bytes.word(uint32_t(v));
    }
    std::fwrite(header.data(), 1, header.size(), file.file());
    std::fwrite(bytes.text().data(), 1, bytes.text().size(), file.file());
    if (std::fflush(file.file()) == 0 && !std::ferror(file.file()))
        return true;
    return file.commit(failure); // which fails and says why
}

std::vector<const Column*> usual_columns(const PointFile& points) {
    std::vector<const Column*> columns;
    if (points.find("red") && points.find("green") && points.find("blue")) {
        for (const auto& [name, letter] : colour_columns)
            if (const Column* column = points.find(name))
                columns.push_back(column);
        return columns;
    }
    if (const Column* z = points.find("z"))
        return {z};
    for (const Column& column : points.columns)
        columns.push_back(&column);
    return columns;
}

namespace {

/// The range of the numbers that are finite, as what makes 0 to 1 of them.
class Range {
public:
    template <class Numbers>
    explicit Range(const Numbers& numbers) {
        double high = -INFINITY;
        for (const double v : numbers)
            if (std::isfinite(v)) {
                m_low = std::min(m_low, v);
                high = std::max(high, v);
            }
        m_scale = high > m_low ? 1 / (high - m_low) : 0;
    }
    double share(double v) const { return (v - m_low) * m_scale; }

private:
    double m_low = INFINITY, m_scale = 0;
};

/// As floats, whose sums and quotients are finite.
std::vector<double> floats_of(const Column& column) {
    std::vector<double> values;
    values.reserve(column.values.size());
    for (const double v : column.values)
        values.push_back(double(float(v)));
    return values;
}

} // namespace

std::vector<float> guide_of(const PointFile& points, const std::vector<const Column*>& columns) {
    std::vector<const Column*> parts;
    for (const Column* column : columns)
        if (!column->is_alpha())
            parts.push_back(column);
    if (parts.empty())
        parts = columns;
    // Up to three are one quantity's, a colour or a vector. More are not.
    const bool unlike = parts.size() > 3;
    std::vector<double> sum(points.mesh.x.size(), 0);
    for (const Column* column : parts) {
        const std::vector<double> values = floats_of(*column);
        const Range range(values);
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += unlike ? range.share(values[i]) : values[i];
    }
    const Range range(sum);
    std::vector<float> guide(sum.size(), 0.0f);
    for (size_t i = 0; i < sum.size(); ++i)
        if (std::isfinite(sum[i]))
            guide[i] = float(range.share(sum[i]));
    return guide;
}

} // namespace ddt::tool
