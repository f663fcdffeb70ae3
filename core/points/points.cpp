// SPDX-License-Identifier: Apache-2.0
#include "core/points/points.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/float_mode.h"
#include "core/base/guarded.h"
#include "core/base/log.h"
#include "core/base/progress.h"
#include "core/base/stopwatch.h"
#include "core/gl/offload.h"
#include "core/guide/guide.h"
#include "core/tiles/work_line.h"
#include "core/tin/delaunay.h"
#include "core/tin/step_grid.h"
#include "core/tin/tin_mesh.h"
#include "ddt/names.h"
#include "ddt/option_table.h"

namespace ddt {

namespace {

/// Whether there are three points, sorted and all different, that are not on one line.
bool spans_plane(const std::vector<Steps>& points) {
    return std::any_of(points.begin(), points.end(),
                       [&](Steps p) { return orientation(points.front(), points.back(), p) != 0; });
}

/// As for an image of as many pixels. One thread works on points; but how much a GPU gains on them
/// is not known, and what is asked of it are many small steps.
bool choose(Device device, size_t points, const MeshOptions& options, Placement& placement,
            std::string& error) {
    Job job;
    job.mesh = options;
    job.device = device;
    constexpr size_t as_if_threads = 5;
    return choose_device(job, points / as_if_threads, placement, error);
}

/// With nothing of what is for pixels alone, allowed or not.
MeshOptions for_points(MeshOptions options) {
    options.blur = 0;
    options.contour = 0;
    options.meshes = 1;
    options.start = Start::flat;
    return options;
}

void flip(Tin& tin, const MeshOptions& options, const Placement& placement, Workspace& workspace,
          Statistics& statistics) {
    statistics.device = Device::cpu;
    if (placement.gpu && tin_on_gpu(options)) {
        const Tin before = tin;
        const std::string failure =
            flip_on_gpu(*placement.gpu, tin, options, workspace, statistics);
        if (failure.empty()) {
            statistics.pixels += int64_t(tin.vertices.size());
            statistics.device = placement.device;
            return;
        }
        if (verbose())
            say("ddt: %s failed, finished on the CPU: %s", describe(placement).c_str(),
                failure.c_str());
        tin = before;
    }
    triangulate(tin, options, workspace, statistics);
}

} // namespace

bool delaunay_points(PointMesh& mesh, Ties ties, std::string& error,
                     const ProgressCallback& progress) {
    const DenormalsAreZero as_on_gpus;
    StepGrid grid;
    if (!grid.fit(mesh.x, mesh.y, error))
        return false;
    // The points row by row, of those at one position the first alone.
    std::vector<int32_t> order(mesh.x.size());
    std::iota(order.begin(), order.end(), 0);
    const std::vector<Tin::Vertex> vertices = vertices_of(grid, mesh.x, mesh.y);
    const auto at = [&](int32_t i) { return vertices[size_t(i)].at; };
    std::stable_sort(order.begin(), order.end(),
                     [&](int32_t i, int32_t k) { return before(at(i), at(k)); });
    order.erase(std::unique(order.begin(), order.end(),
                            [&](int32_t i, int32_t k) {
                                return !before(at(i), at(k)) && !before(at(k), at(i));
                            }),
                order.end());
    std::vector<Steps> points;
    std::vector<float> guide;
    for (const int32_t i : order) {
        points.push_back(at(i));
        if (ties.guide)
            guide.push_back(ties.guide[i]);
    }
    if (!spans_plane(points)) {
        error = "ddt: triangles need 3 points that are not on one line or too flat beside their "
                "extent";
        return false;
    }
    std::vector<std::array<int32_t, 3>> triangles;
    if (!find_delaunay(points, triangles, {ties.guide ? guide.data() : nullptr, ties.seed},
                       progress)) {
        error = "ddt: cancelled";
        return false;
    }
    for (auto& t : triangles)
        for (int32_t& v : t)
            v = order[size_t(v)];
    mesh.triangles = std::move(triangles);
    return true;
}

/// Make a mesh of its triangles on its grid. On that of all points where the corners' own is too
/// fine: so it is of a mesh that was made with points far away and lost their triangles, others of
/// which turn over where they are no longer rounded as they were then.
bool connect_points(const PointMesh& mesh, Tin& tin, std::string& error) {
    StepGrid grid;
    if (!grid.fit(mesh, error))
        return false;
    tin.vertices = vertices_of(grid, mesh.x, mesh.y);
    if (connect(tin, mesh.triangles, error))
        return true;
    std::string of_all;
    tin = {};
    if (!grid.fit(mesh.x, mesh.y, of_all))
        return false;
    tin.vertices = vertices_of(grid, mesh.x, mesh.y);
    return connect(tin, mesh.triangles, of_all);
}

bool optimise_points(PointMesh& mesh, const float* guide, const MeshOptions& given,
                     MeshReport* report, std::string& error, const ProgressCallback& progress,
                     Device device) {
    const DenormalsAreZero as_on_gpus;
    const MeshOptions options = for_points(given);
    Placement placement;
    FilterOptions all;
    all.mesh = options;
    all.device = device;
    Tin tin;
    if (!check_options(all, error) || !choose(device, mesh.x.size(), options, placement, error) ||
        !connect_points(mesh, tin, error))
        return false;
    for (size_t i = 0; i < tin.vertices.size(); ++i) {
        tin.vertices[i].guide = guide[i];
        clean_guide(&tin.vertices[i].guide, 1);
    }
    bool going = true;
    // Not to be asked again by the CPU if a GPU fails after it was cancelled.
    const ProgressCallback once = until_it_ends(progress), rising = never_falling(once);
    Workspace workspace;
    if (progress)
        workspace.progress = [&](float share) { return going = rising(share); };
    MeshReport what;
    if (report)
        what.cost_start = total_cost(TinMesh(tin, options.cost));
    flip(tin, options, placement, workspace, what.statistics);
    if (!going) {
        error = "ddt: cancelled";
        return false;
    }
    if (report) {
        what.cost = total_cost(TinMesh(tin, options.cost));
        *report = what;
    }
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        std::copy_n(tin.triangles[t].vertex, 3, mesh.triangles[t].begin());
    return true;
}

bool delaunay(PointMesh& mesh, std::string* error, const ProgressCallback& progress) noexcept {
    return succeeds(error,
                    [&](std::string& why) { return delaunay_points(mesh, {}, why, progress); });
}

bool optimise(PointMesh& mesh, const float* guide, const MeshOptions& options, MeshReport* report,
              std::string* error, const ProgressCallback& progress, Device device) noexcept {
    return succeeds(error, [&](std::string& why) {
        const Stopwatch watch;
        const bool told = verbose();
        MeshReport own;
        MeshReport* const made = told && !report ? &own : report;
        if (!optimise_points(mesh, guide, options, made, why, progress, device))
            return false;
        if (told)
            say_worked(device_name(made->statistics.device),
                       std::to_string(made->statistics.pixels) + " points", made->statistics,
                       watch.milliseconds());
        return true;
    });
}

} // namespace ddt
