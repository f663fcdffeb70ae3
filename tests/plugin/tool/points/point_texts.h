// SPDX-License-Identifier: Apache-2.0
// Files of points, as text.
#pragma once

#include <algorithm>
#include <fstream>
#include <string>

#include "tests/temporary.h"

namespace ddt::tool {

/// The path of a temporary file with this text.
inline std::string write_file(const std::string& name, const std::string& text) {
    const std::string path = temporary(name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

/// A square of 4 x 4 with z = x + 10 y in its corners and middle, as text.
inline const char* const plane = "x,y,z,weight\n0,0,0,1\n4,0,4,2\n0,4,40,3\n4,4,44,4\n2,2,22,nan\n";

/// A mesh of one face after a triangle far below it, as text.
inline std::string with_face(const std::string& vertices, const std::string& face) {
    const auto count = std::count(vertices.begin(), vertices.end(), '\n');
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count + 3) +
           "\nproperty double x\nproperty double y\nproperty float z\nelement face 2\n"
           "property list uchar int vertex_indices\nend_header\n" +
           vertices + "0 -9 0\n1 -9 0\n0 -8 0\n3 " + std::to_string(count) + ' ' +
           std::to_string(count + 1) + ' ' + std::to_string(count + 2) + '\n' + face + '\n';
}

} // namespace ddt::tool
