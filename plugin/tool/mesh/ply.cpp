// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "plugin/tool/file/little_endian.h"
#include "plugin/tool/mesh/mesh_file.h"
#include "plugin/tool/mesh/writing_progress.h"

namespace ddt::tool {

bool write_ply(std::FILE* file, const Mesh& mesh, const Picture& picture, const MeshStyle& style,
               const ProgressCallback& progress) {
    std::fprintf(file,
                 "ply\nformat binary_little_endian 1.0\n"
                 "element vertex %zu\nproperty float x\nproperty float y\nproperty float z\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\n%s"
                 "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
                 picture.colours.size(), picture.has_alpha ? "property uchar alpha\n" : "",
                 mesh.triangles.size());
    LittleEndian record;
    for (int y = 0; y < mesh.height; ++y) {
        for (int x = 0; x < mesh.width; ++x) {
            const size_t i = size_t(y) * size_t(mesh.width) + size_t(x);
            const Colour& c = picture.colours[i];
            record.number(float(x));
            record.number(float(mesh.height - 1 - y));
            record.number(lift(picture, i, style));
            for (const float v : {c.red, c.green, c.blue})
                record.word(uint8_t(byte_of(v)));
            if (picture.has_alpha)
                record.word(uint8_t(byte_of(c.alpha)));
            record.write(file);
        }
        if (!tell_row(mesh, y, progress))
            return false;
    }
    size_t n = 0;
    for (const auto& t : mesh.triangles) {
        record.word(uint8_t(3));
        // With y upwards the other way round is counter-clockwise.
        for (const int k : {0, 2, 1})
            record.word(uint32_t(t[size_t(k)]));
        record.write(file);
        if (!tell_triangle(mesh, ++n, progress))
            return false;
    }
    return true;
}

} // namespace ddt::tool
