// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/ply_types.h"

#include <cmath>

namespace ddt::tool {

namespace {

constexpr PlyType ply_types[] = {
    {"char", "int8", PlyNumber::int8, 1},        {"uchar", "uint8", PlyNumber::uint8, 1},
    {"short", "int16", PlyNumber::int16, 2},     {"ushort", "uint16", PlyNumber::uint16, 2},
    {"int", "int32", PlyNumber::int32, 4},       {"uint", "uint32", PlyNumber::uint32, 4},
    {"float", "float32", PlyNumber::float32, 4}, {"double", "float64", PlyNumber::float64, 8},
};

} // namespace

const PlyType* find_ply_type(const std::string& name) {
    for (const PlyType& n : ply_types)
        if (name == n.name || name == n.other)
            return &n;
    return nullptr;
}

bool has_room(const PlyType& type, double v) {
    if (type.number == PlyNumber::float32 || type.number == PlyNumber::float64)
        return true;
    const bool is_signed = type.number == PlyNumber::int8 || type.number == PlyNumber::int16 ||
                           type.number == PlyNumber::int32;
    const double codes = std::ldexp(1.0, int(type.bytes) * 8);
    const double low = is_signed ? -codes / 2 : 0;
    return v == std::floor(v) && v >= low && v < low + codes;
}

} // namespace ddt::tool
