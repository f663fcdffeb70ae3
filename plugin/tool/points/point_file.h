// SPDX-License-Identifier: Apache-2.0
// Reading files of points with values, and of meshes of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ddt/points.h"
#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/points/columns.h"

namespace ddt::tool {

struct PointFile {
    PointMesh mesh;              ///< with the file's triangles, if it has any
    std::vector<uint32_t> faces; ///< of which of the file's faces each of its triangles is
    std::vector<Column> columns;

    /// The column of that name, or null.
    const Column* find(const std::string& name) const;
    /// That one, or else the one of that name in other capitals, or of the colour that R, G, B or A
    /// stands for.
    const Column* find_meant(const std::string& name) const;
};

/// Read PLY (text or binary, in either order of bytes; polygons become triangles, fans where these
/// lie side by side), known by its name or first line, or else text: a line that names the columns,
/// x and y among them, then a line a point; between columns commas, semicolons, tabs or spaces, and
/// between commas or semicolons perhaps nothing: a value that is a NaN, or, at the end of all
/// lines, no column; empty lines and lines that begin with # or // are passed over, but for a first
/// line that names columns after these. In a text, red, green and blue that are all whole numbers
/// from 0 to 255, some above 1, are bytes, and so is alpha, by itself; there they may be called R,
/// G, B and A, and alpha A without them. False with a failure that names file and line, from 1, or
/// vertex or face, as PLY counts them from 0; also where a position is not finite.
bool read_points(const std::string& path, PointFile& points, Failure& failure);

/// What delaunay() or optimise() said of the points of a file, with its name, and the face for the
/// triangle. What is not about the points stays as it is.
std::string fault_in(const std::string& path, const PointFile& points, const std::string& why);

/// The number that all of a word is, as C reads it ("1e3", "nan", "0x10"), or none.
std::optional<double> number_in(const std::string& word);

/// The two readers of it.
bool read_ply(const std::string& text, PointFile& points, std::string& error);
bool read_table(const std::string& text, PointFile& points, std::string& error);

} // namespace ddt::tool
