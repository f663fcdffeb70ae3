// SPDX-License-Identifier: Apache-2.0
#include "ddt/mesh.h"

#include "core/base/arith.h"
#include "core/base/guarded.h"
#include "core/enlarge/mesh_size.h"
#include "core/guide/guide.h"
#include "core/lattice/list_triangles.h"
#include "core/tiles/tile_io.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"
#include "ddt/option_table.h"

namespace ddt {

namespace {

/// A lattice's site indices, doubled, must fit an int32.
constexpr int64_t most_pixels = int64_t(1) << 28;

void list(const Lattice& lattice, Mesh& mesh) {
    const int stride = lattice.stride();
    const auto vertex = [&](int site) {
        return int32_t(site / stride / 2 * lattice.width() + site % stride / 2);
    };
    mesh.width = lattice.width();
    mesh.height = lattice.height();
    mesh.triangles.clear();
    mesh.triangles.reserve(2 * size_t(mesh.width - 1) * size_t(mesh.height - 1));
    each_triangle(lattice, [&](int a, int b, int c) {
        mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    });
}

/// False: cancelled.
bool build(const float* guide, int width, int height, const MeshOptions& options, Mesh& mesh,
           MeshReport* report, const std::function<bool(float)>& progress) {
    const DenormalsAreZero as_on_gpus;
    Lattice lattice;
    Workspace workspace;
    Statistics statistics;
    bool going = true;
    if (progress)
        workspace.progress = [&](float share) { return going = progress(share); };
    std::vector<float> own(guide, guide + size_t(width) * size_t(height));
    clean_guide(own.data(), own.size());
    if (options.blur > 0)
        blur_guide(own.data(), width, height, options.blur);
    start(lattice, width, height, own.data(), options);
    const double cost_start = report ? total_cost(lattice, options.cost) : 0;
    triangulate(lattice, options, workspace, statistics);
    if (!going)
        return false;
    if (report)
        *report = {cost_start, total_cost(lattice, options.cost), statistics};
    workspace = {};
    list(lattice, mesh);
    return true;
}

} // namespace

bool check_mesh_size(int width, int height, std::string& error) {
    if (width < 2 || height < 2)
        error = "ddt: a mesh needs at least 2 x 2 pixels";
    else if (int64_t(width) * height > most_pixels)
        error = "ddt: the image is too large for one mesh";
    else
        return true;
    return false;
}

bool build_mesh(const float* guide, int width, int height, const MeshOptions& options, Mesh& mesh,
                MeshReport* report, std::string* error,
                const std::function<bool(float)>& progress) {
    return succeeds(error, [&](std::string& why) {
        if (check_mesh_size(width, height, why) && check_options(options, why) &&
            !build(guide, width, height, options, mesh, report, progress))
            why = "ddt: cancelled";
        return why.empty();
    });
}

} // namespace ddt
