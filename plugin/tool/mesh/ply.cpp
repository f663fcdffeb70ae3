// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstring>

#include "plugin/tool/mesh/mesh_file.h"

namespace ddt::tool {

namespace {

/// Bytes in little endian order, whatever the machine's is.
class Record {
public:
    explicit Record(std::FILE* file) : m_file(file) {}
    void byte(int v) { m_bytes[m_size++] = uint8_t(v); }
    void word(uint32_t v) {
        for (int k = 0; k < 4; ++k, v >>= 8)
            byte(int(v & 0xff));
    }
    void number(float v) {
        uint32_t bits;
        std::memcpy(&bits, &v, sizeof bits);
        word(bits);
    }
    void write() {
        std::fwrite(m_bytes, 1, m_size, m_file);
        m_size = 0;
    }

private:
    std::FILE* m_file;
    uint8_t m_bytes[16];
    size_t m_size = 0;
};

} // namespace

bool write_ply(std::FILE* file, const Mesh& mesh, const Picture& picture, const MeshStyle& style,
               const ProgressCallback& progress) {
    std::fprintf(file,
                 "ply\nformat binary_little_endian 1.0\n"
                 "element vertex %zu\nproperty float x\nproperty float y\nproperty float z\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\n%s"
                 "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
                 picture.colours.size(), picture.has_alpha ? "property uchar alpha\n" : "",
                 mesh.triangles.size());
    Record record(file);
    for (int y = 0; y < mesh.height; ++y) {
        for (int x = 0; x < mesh.width; ++x) {
            const size_t i = size_t(y) * size_t(mesh.width) + size_t(x);
            const Colour& c = picture.colours[i];
            record.number(float(x));
            record.number(float(mesh.height - 1 - y));
            record.number(lift(picture, i, style));
            for (const float v : {c.red, c.green, c.blue})
                record.byte(byte_of(v));
            if (picture.has_alpha)
                record.byte(byte_of(c.alpha));
            record.write();
        }
        if (!progress(0.5f * float(y) / float(mesh.height)))
            return false;
    }
    size_t n = 0;
    for (const auto& t : mesh.triangles) {
        record.byte(3);
        // With y upwards the other way round is counter-clockwise.
        for (const int k : {0, 2, 1})
            record.word(uint32_t(t[size_t(k)]));
        record.write();
        if (++n % 65536 == 0 && !progress(0.5f + 0.5f * float(n) / float(mesh.triangles.size())))
            return false;
    }
    return true;
}

} // namespace ddt::tool
