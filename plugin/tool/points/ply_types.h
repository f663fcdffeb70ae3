// SPDX-License-Identifier: Apache-2.0
// The types of numbers that PLY has.
#pragma once

#include <cstddef>
#include <string>

namespace ddt::tool {

enum class PlyNumber { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyType {
    const char *name, *other; ///< "uchar", and as some call it: "uint8"
    PlyNumber number;
    size_t bytes;
};

/// The type of either name, or null.
const PlyType* find_ply_type(const std::string& name);

/// Whether a type of whole numbers has this one. Floats have all: rounded, and infinite beyond.
bool has_room(const PlyType& type, double v);

} // namespace ddt::tool
