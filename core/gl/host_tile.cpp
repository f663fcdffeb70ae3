// SPDX-License-Identifier: Apache-2.0
#include "core/gl/host_tile.h"

#include <cstring>

#include "core/base/arith.h"
#include "core/guide/guide.h"
#include "core/tiles/tile_io.h"
#include "core/triangulate/triangulate.h"

namespace ddt::gl {

namespace {

/// The channels in groups, a group's pixels in rows of the slot.
void lay_out(const std::vector<float>& values, const Job& job, const SlotShape& shape,
             HostTile& t) {
    const int groups = group_count(job.channels);
    const size_t pixels = shape.pixels();
    t.values.assign(pixels * size_t(groups) * group_size, 0.0f);
    const float* in = values.data();
    for (int y = 0; y < t.size.height; ++y)
        for (int x = 0; x < t.size.width; ++x, in += job.channels) {
            float* out =
                t.values.data() + (size_t(y) * size_t(shape.width) + size_t(x)) * group_size;
            for (int g = 0; g < groups; ++g, out += pixels * group_size)
                std::memcpy(out, in + g * group_size,
                            size_t(channels_in_group(job.channels, g)) * sizeof(float));
        }
}

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
    const size_t row = size_t(2 * t.size.width - 1);
    for (int y = 0; y < 2 * t.size.height - 1; ++y)
        std::memcpy(sites + size_t(y) * size_t(shape.stride()),
                    lattice.sites() + lattice.site(0, y), row * sizeof(Site));
    // A vertex' second word: the key of one of its edges (edge_key in shaders/lattice.glsl).
    lattice.find_first_edges(lattice.all());
    for (int y = 0; y < t.size.height; ++y)
        for (int x = 0; x < t.size.width; ++x) {
            const Vertex& vertex = lattice.vertex(lattice.vertex_site(x, y));
            const auto key = unsigned(vertex.first.y + 128) << 8 | unsigned(vertex.first.x + 128);
            uint64_t& site = sites[size_t(2 * y) * size_t(shape.stride()) + size_t(2 * x)];
            site = (site & 0xffffffffu) | uint64_t(key) << 32;
        }
}

} // namespace

bool read(Source& source, const Job& job, const SlotShape& shape, HostTile& t) {
    std::vector<float> values, guide;
    int width = 0, height = 0;
    if (!read_tile(source, t.tile, job, values, guide, width, height))
        return false;
    t.size = size_in_slot(t.tile, job.window, width, height);
    lay_out(values, job, shape, t);
    const auto meshes = size_t(job.mesh.meshes);
    const bool here = !DeviceMesh::knows(job.mesh);
    if (here)
        t.sites.resize(meshes * shape.sites());
    // Soft edges' gains are found on the device in any case, and contours by the guide.
    const bool with_guides = !here || job.mesh.contour != 0;
    if (with_guides)
        t.guides.resize(meshes * shape.pixels());
    for (size_t k = 0; k < meshes; ++k) {
        std::vector<float> blurred = guide;
        if (const float share = blur_share(job.mesh, int(k)); share > 0)
            blur_guide(blurred, width, height, share);
        if (here)
            triangulate_here(blurred, job, shape, t, t.sites.data() + k * shape.sites());
        for (int y = 0; with_guides && y < height; ++y)
            std::memcpy(t.guides.data() + k * shape.pixels() + size_t(y) * size_t(shape.width),
                        blurred.data() + size_t(y) * size_t(width), size_t(width) * sizeof(float));
    }
    return true;
}

void upload(const HostTile& t, const Job& job, int first_slot, DeviceMesh& mesh,
            Surfaces& surfaces) {
    const SlotShape& shape = mesh.shape();
    for (int k = 0; k < job.mesh.meshes; ++k) {
        if (!t.guides.empty())
            mesh.write_guide(first_slot + k, t.guides.data() + size_t(k) * shape.pixels());
        if (!t.sites.empty())
            mesh.write_sites(first_slot + k, t.sites.data() + size_t(k) * shape.sites());
    }
    upload_values(t, job, first_slot, surfaces);
}

void upload_values(const HostTile& t, const Job& job, int first_slot, Surfaces& surfaces) {
    const int groups = group_count(job.channels);
    const size_t floats = t.values.size() / size_t(groups);
    for (int k = 0; k < job.mesh.meshes; ++k)
        for (int g = 0; g < groups; ++g)
            surfaces.write_values(first_slot + k, g, t.values.data() + size_t(g) * floats);
}

std::vector<GroupKinds> kinds_of(const Job& job) {
    std::vector<GroupKinds> groups;
    for (int g = 0; g < group_count(job.channels); ++g) {
        GroupKinds kinds;
        kinds.nearest = nearest_mask(job, g);
        for (int c = 0; c < group_size; ++c)
            if (is_strict(job, g * group_size + c))
                kinds.strict |= 1u << c;
        groups.push_back(kinds);
    }
    return groups;
}

} // namespace ddt::gl
