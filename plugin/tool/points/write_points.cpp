// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/write_points.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "plugin/message/format.h"
#include "plugin/tool/file/little_endian.h"
#include "plugin/tool/points/ply_types.h"

namespace ddt::tool {

namespace {

/// The nearest whole number that the type holds.
template <class Whole>
Whole nearest(double v) {
    using Limits = std::numeric_limits<Whole>;
    return v > double(Limits::min()) ? Whole(std::min(std::floor(v + 0.5), double(Limits::max())))
           : v < 0                   ? Limits::min()
                                     : Whole(0);
}

/// As a number of the type; of a type that PLY has not, as a float.
void put(double v, const PlyType* type, LittleEndian& to) {
    switch (type ? type->number : PlyNumber::float32) {
    case PlyNumber::int8:
        return to.word(nearest<int8_t>(v));
    case PlyNumber::uint8:
        return to.word(nearest<uint8_t>(v));
    case PlyNumber::int16:
        return to.word(nearest<int16_t>(v));
    case PlyNumber::uint16:
        return to.word(nearest<uint16_t>(v));
    case PlyNumber::int32:
        return to.word(nearest<int32_t>(v));
    case PlyNumber::uint32:
        return to.word(nearest<uint32_t>(v));
    case PlyNumber::float32:
        return to.number(float(v));
    case PlyNumber::float64:
        return to.number(v);
    }
}

/// A name as PLY has them: one word.
std::string written_name(const Column& column) {
    std::string name = column.name.empty() ? "unnamed" : column.name;
    for (char& c : name)
        if ((unsigned char)(c) <= ' ')
            c = '_';
    return name;
}

std::string header_of(const PointFile& points) {
    std::string header = format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
                                "property double x\nproperty double y\n",
                                points.mesh.x.size());
    for (const Column& column : points.columns)
        header += format("property {} {}\n", column.type, written_name(column));
    return header + format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                           points.mesh.triangles.size());
}

} // namespace

bool write_points(const std::string& path, const PointFile& points, Failure& failure) {
    WholeFile file;
    return file.open(path, failure) && write_points(file, points, failure) && file.commit(failure);
}

bool write_points(WholeFile& file, const PointFile& points, Failure& failure) {
    const std::string header = header_of(points);
    std::fwrite(header.data(), 1, header.size(), file.file());
    std::vector<const PlyType*> types;
    for (const Column& column : points.columns)
        types.push_back(find_ply_type(column.type));
    LittleEndian record;
    for (size_t i = 0; i < points.mesh.x.size(); ++i) {
        record.number(points.mesh.x[i]);
        record.number(points.mesh.y[i]);
        for (size_t k = 0; k < types.size(); ++k)
            put(points.columns[k].values[i] * points.columns[k].scale, types[k], record);
        record.write(file.file());
    }
    for (const auto& t : points.mesh.triangles) {
        record.word(uint8_t(3));
        for (const int32_t v : t)
            record.word(uint32_t(v));
        record.write(file.file());
    }
    if (std::fflush(file.file()) == 0 && !std::ferror(file.file()))
        return true;
    return file.commit(failure); // which fails and says why
}

} // namespace ddt::tool
