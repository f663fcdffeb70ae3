// SPDX-License-Identifier: Apache-2.0
#include "ddt/mesh.h"

#include <algorithm>
#include <utility>

#include "core/base/float_mode.h"
#include "core/base/guarded.h"
#include "core/base/progress.h"
#include "core/enlarge/build_mesh.h"
#include "core/guide/guide.h"
#include "core/lattice/each_triangle.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"
#include "ddt/option_table.h"

namespace ddt {

namespace {

/// A lattice's site indices, doubled, must fit an int32.
constexpr int64_t most_pixels = int64_t(1) << 28;

/// Of the time, about, by when the starting mesh is made from, edges flip, and triangles are
/// listed.
constexpr float start_begins = 0.05f, flips_begin = 0.3f, list_begins = 0.55f;

/// Rows of sites that are listed between two calls of progress.
constexpr int rows_between_calls = 64;

/// False: cancelled.
bool list(const Lattice& lattice, Mesh& mesh, const ProgressCallback& progress) {
    const int stride = lattice.stride();
    const auto vertex = [&](int site) {
        return int32_t(site / stride / 2 * lattice.width() + site % stride / 2);
    };
    mesh.width = lattice.width();
    mesh.height = lattice.height();
    mesh.triangles.reserve(2 * size_t(mesh.width - 1) * size_t(mesh.height - 1));
    const int rows = 2 * mesh.height - 1;
    for (int y = 0; y < rows; y += rows_between_calls) {
        const int end = std::min(y + rows_between_calls, rows);
        each_triangle(lattice, y, end, [&](int a, int b, int c) {
            mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
        });
        if (progress && !progress(float(end) / float(rows)))
            return false;
    }
    return true;
}

/// False: cancelled. What `progress` is told may fall.
bool build(const float* guide, int width, int height, const MeshOptions& options, Mesh& mesh,
           MeshReport* report, const ProgressCallback& progress) {
    const DenormalsAreZero as_on_gpus;
    const ProgressCallback flips = part_of(progress, flips_begin, list_begins);
    const auto go_on = [&](float share) { return !progress || progress(share); };
    Lattice lattice;
    Workspace workspace;
    MeshReport made;
    Mesh listed;
    bool going = true;
    if (progress)
        workspace.progress = [&](float share) { return going = flips(share); };
    std::vector<float> own(guide, guide + size_t(width) * size_t(height));
    clean_guide(own.data(), own.size());
    if (options.blur > 0)
        blur_guide(own.data(), width, height, options.blur);
    if (!go_on(start_begins))
        return false;
    start(lattice, width, height, own.data(), options);
    if (!go_on(flips_begin))
        return false;
    if (report)
        made.cost_start = total_cost(lattice, options.cost);
    triangulate(lattice, options, workspace, made.statistics);
    if (!going)
        return false;
    if (report)
        made.cost = total_cost(lattice, options.cost);
    workspace = {};
    if (!list(lattice, listed, part_of(progress, list_begins, 1)))
        return false;
    if (report)
        *report = made;
    mesh = std::move(listed);
    return true;
}

} // namespace

bool check_mesh_size(int width, int height, std::string& error) {
    if (width < 2 || height < 2)
        error = "ddt: a mesh needs at least 2 x 2 pixels";
    else if (int64_t(width) * height > most_pixels)
        error = "ddt: the image is too large for one mesh; allowed are 2^28 pixels";
    else
        return true;
    return false;
}

bool build_mesh(const float* guide, int width, int height, const MeshOptions& options, Mesh& mesh,
                MeshReport* report, std::string* error, const ProgressCallback& progress) noexcept {
    return succeeds(error, [&](std::string& why) {
        if (!guide)
            why = "ddt: the guide is null; a mesh needs a number per pixel";
        else if (check_mesh_size(width, height, why) && check_options(options, why) &&
                 !build(guide, width, height, options, mesh, report, never_falling(progress)))
            why = "ddt: cancelled";
        return why.empty();
    });
}

} // namespace ddt
