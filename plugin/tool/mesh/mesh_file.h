// SPDX-License-Identifier: Apache-2.0
// Writing a mesh to a file.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "ddt/mesh.h"
#include "ddt/progress.h"
#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/file/picture.h"

namespace ddt::tool {

/// What is drawn of a triangle in SVG.
enum class Fill { flat, gradient, none };

struct MeshStyle {
    Fill fill = Fill::gradient;
    double lines = 0;  ///< SVG: width of the edges drawn over the triangles, in pixels; 0: none
    double height = 0; ///< PLY, OBJ: z of a white pixel; z is picture.heights times this
};

/// Writes a mesh with the picture's colours. Calls progress with the share done.
///
/// SVG: one <path> a triangle, in pixels, y downwards; the picture spans the pixel centres. Flat:
/// the mean of the three colours. Gradient: the plane through the three colours as far as one
/// gradient shows it, along the steepest way of luminance. PLY (binary, little endian) and OBJ: x
/// to the right, y upwards, z towards the viewer, triangles counter-clockwise; PLY with colours of
/// 8 bits and with alpha if the picture has it, OBJ with the widespread extension "v x y z r g b".
using MeshWriter = bool (*)(std::FILE*, const Mesh&, const Picture&, const MeshStyle&,
                            const ProgressCallback& progress);
bool write_svg(std::FILE*, const Mesh&, const Picture&, const MeshStyle&,
               const ProgressCallback& progress);
bool write_ply(std::FILE*, const Mesh&, const Picture&, const MeshStyle&,
               const ProgressCallback& progress);
bool write_obj(std::FILE*, const Mesh&, const Picture&, const MeshStyle&,
               const ProgressCallback& progress);

/// The writer for a file's extension, or null.
MeshWriter writer_for(const std::string& path);
/// The message about a name that has none.
std::string wrong_mesh_name(const std::string& path);

/// Write the file, whole or not at all.
bool write_mesh(const std::string& path, const Mesh& mesh, const Picture& picture,
                const MeshStyle& style, const ProgressCallback& progress, Failure& failure);

/// A vertex's z: 0 for all without heights, and where it would not be finite.
inline float lift(const Picture& picture, size_t vertex, const MeshStyle& style) {
    const double z = picture.heights.empty() ? 0 : double(picture.heights[vertex]) * style.height;
    return std::fabs(z) <= double(std::numeric_limits<float>::max()) ? float(z) : 0.0f;
}

/// A display value as 8 bits; NaN is 0.
inline int byte_of(float v) {
    return v > 0.0f ? v < 1.0f ? int(v * 255.0f + 0.5f) : 255 : 0;
}

} // namespace ddt::tool
