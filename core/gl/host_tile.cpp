// SPDX-License-Identifier: Apache-2.0
#include "core/gl/host_tile.h"

#include "core/base/float_mode.h"
#include "core/guide/guide.h"
#include "core/tiles/channel_groups.h"
#include "core/tiles/tile_io.h"
#include "core/triangulate/triangulate.h"

namespace ddt::gl {

namespace {

/// Make the mesh of the guide here, and its sites as shaders want them.
void triangulate_here(const std::vector<float>& guide, const Job& job, const SlotShape& shape,
                      HostTile& t, uint64_t* sites) {
    const DenormalsAreZero as_on_gpus;
    Lattice lattice;
    Workspace workspace;
    workspace.origin_x = t.tile.pixels.x0 - job.window.x0;
    workspace.origin_y = t.tile.pixels.y0 - job.window.y0;
    start(lattice, t.size.width, t.size.height, guide.data(), job.mesh);
    triangulate(lattice, job.mesh, workspace, t.statistics);
    const auto at = [&](int x, int y) -> uint64_t& {
        return sites[size_t(y) * size_t(shape.stride()) + size_t(x)];
    };
    lattice.each_edge([&](int m) {
        at(m % lattice.stride(), m / lattice.stride()) = vectors_of(lattice.edge(m));
    });
    // A vertex' second word: the key of one of its edges (edge_key in shaders/lattice.glsl).
    lattice.find_first_edges(lattice.all());
    for (int y = 0; y < t.size.height; ++y)
        for (int x = 0; x < t.size.width; ++x) {
            const Vertex& vertex = lattice.vertex(lattice.vertex_site(x, y));
            const auto key = unsigned(vertex.first.y + 128) << 8 | unsigned(vertex.first.x + 128);
            at(2 * x, 2 * y) = bits_of(vertex.guide) | uint64_t(key) << 32;
        }
}

size_t guides_room(const Job& job, const SlotShape& shape) {
    return with_guides(job) ? size_t(job.mesh.meshes) * guide_room(shape.pixels()) : 0;
}

/// Read a tile's numbers to `to`, and its guide.
bool read_numbers(Source& source, const Tile& tile, const Job& job, const Numbers& numbers,
                  std::byte* to, std::vector<float>& guide, int& width, int& height) {
    if (numbers.coded()) {
        width = tile.pixels.width();
        height = tile.pixels.height();
        guide.resize(tile.pixels.area());
        if (!source.read_codes(tile.pixels, to, guide.data()))
            return false;
        clean_guide(guide.data(), guide.size());
        return true;
    }
    guide.resize(size_t(lattice_width(tile)) * size_t(lattice_height(tile)));
    return read_tile(source, tile, job, reinterpret_cast<float*>(to), guide.data(), width, height);
}

} // namespace

bool with_guides(const Job& job) {
    // Soft edges' gains are found on the device in any case, and contours by the guide.
    return DeviceMesh::knows(job.mesh) || job.mesh.contour != 0;
}

size_t host_bytes(const Job& job, const SlotShape& shape, const Numbers& numbers) {
    return guides_room(job, shape) + numbers.room(shape.pixels() * size_t(job.channels));
}

bool read(Source& source, const Job& job, const SlotShape& shape, const Numbers& numbers,
          HostTile& t, ReadMemory& memory) {
    if (!t.memory)
        t.memory = std::make_unique<HostBuffer>(host_bytes(job, shape, numbers));
    int width = 0, height = 0;
    if (!read_numbers(source, t.tile, job, numbers, t.memory->data() + guides_room(job, shape),
                      memory.guide, width, height))
        return false;
    t.size = size_in_slot(t.tile, job.window, width, height);
    const auto meshes = size_t(job.mesh.meshes);
    const bool here = !DeviceMesh::knows(job.mesh);
    if (here)
        t.sites.resize(meshes * shape.sites());
    t.guide_bytes.resize(meshes);
    for (size_t k = 0; k < meshes; ++k) {
        const std::vector<float>* guide = &memory.guide;
        if (const float share = blur_share(job.mesh, int(k)); share > 0) {
            memory.blurred = memory.guide;
            blur_guide(memory.blurred.data(), width, height, share);
            guide = &memory.blurred;
        }
        if (here)
            triangulate_here(*guide, job, shape, t, t.sites.data() + k * shape.sites());
        if (with_guides(job))
            t.guide_bytes[k] =
                encode_guide(*guide, t.memory->data() + k * guide_room(shape.pixels()));
    }
    return true;
}

size_t upload(const HostTile& t, const Job& job, int first_slot, DeviceMesh& mesh,
              Surfaces& surfaces) {
    size_t bytes = upload_guides(t, job, first_slot, mesh);
    for (int k = 0; !t.sites.empty() && k < job.mesh.meshes; ++k)
        bytes +=
            mesh.write_sites(first_slot + k, t.sites.data() + size_t(k) * mesh.shape().sites());
    return bytes + upload_numbers(t, job, first_slot, mesh.shape(), surfaces);
}

void unpack(const Job& job, DeviceMesh& mesh, Surfaces& surfaces) {
    if (with_guides(job))
        mesh.unpack_guides();
    surfaces.unpack(mesh);
}

size_t upload_guides(const HostTile& t, const Job& job, int first_slot, DeviceMesh& mesh) {
    size_t bytes = 0;
    for (size_t k = 0; with_guides(job) && k < t.guide_bytes.size(); ++k)
        bytes += mesh.write_guide(first_slot + int(k), *t.memory,
                                  k * guide_room(mesh.shape().pixels()), t.guide_bytes[k]);
    return bytes;
}

size_t upload_numbers(const HostTile& t, const Job& job, int first_slot, const SlotShape& shape,
                      Surfaces& surfaces) {
    return surfaces.write_numbers(first_slot / job.mesh.meshes, t.size, *t.memory,
                                  guides_room(job, shape));
}

std::vector<GroupKinds> kinds_of(const Job& job) {
    std::vector<GroupKinds> groups;
    for (int g = 0; g < group_count(job.channels); ++g)
        groups.push_back({nearest_mask(job, g), 0});
    for (const int c : bounded_channels(job))
        groups[size_t(c / group_size)].bounded |= 1u << (c % group_size);
    return groups;
}

} // namespace ddt::gl
