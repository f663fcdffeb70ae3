// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/mesh/mesh_file.h"
#include "plugin/tool/mesh/writing_progress.h"

namespace ddt::tool {

bool write_obj(std::FILE* file, const Mesh& mesh, const Picture& picture, const MeshStyle& style,
               const ProgressCallback& progress) {
    std::fprintf(file, "# vertex: x y z red green blue\no mesh\n");
    for (int y = 0; y < mesh.height; ++y) {
        for (int x = 0; x < mesh.width; ++x) {
            const size_t i = size_t(y) * size_t(mesh.width) + size_t(x);
            const Colour& c = picture.colours[i];
            // As many digits as a float has.
            std::fprintf(file, "v %d %d %.9g %.6g %.6g %.6g\n", x, mesh.height - 1 - y,
                         double(lift(picture, i, style)), double(byte_of(c.red)) / 255,
                         double(byte_of(c.green)) / 255, double(byte_of(c.blue)) / 255);
        }
        if (!tell_row(mesh, y, progress))
            return false;
    }
    size_t n = 0;
    for (const auto& t : mesh.triangles) {
        // Counted from 1. With y upwards the other way round is counter-clockwise.
        std::fprintf(file, "f %d %d %d\n", t[0] + 1, t[2] + 1, t[1] + 1);
        if (!tell_triangle(mesh, ++n, progress))
            return false;
    }
    return true;
}

} // namespace ddt::tool
