// SPDX-License-Identifier: Apache-2.0
#include "core/gl/job_programs.h"

#include <algorithm>

#include "core/gl/device_mesh.h"
#include "core/surface/control_net.h"
#include "core/surface/corrections.h"
#include "core/triangulate/schemes.h"
#include "ddt/names.h"

namespace ddt::gl {

namespace {

/// What DeviceMesh::triangulate() goes through, and find_gains() where that leaves none.
void add_mesh(const MeshOptions& mesh, std::vector<JobProgram>& all) {
    const std::string by = criterion_macros(criterion(mesh));
    const JobProgram gains{"evaluate.comp", by + " DENSE"};
    if (mesh.contour != 0)
        all.push_back({"contours.comp", ""});
    if (!DeviceMesh::knows(mesh))
        return all.push_back(gains);
    all.push_back({"start.comp", by});
    if (mesh.scheme == Scheme::pixel || mesh.max_iterations == 0)
        return all.push_back(gains);
    if (find_rules(mesh)) {
        all.push_back({"accept_reject.comp", by});
        return all.push_back(gains);
    }
    for (const char* step : {"select.comp", "flip.comp"})
        all.push_back({step, ""});
    for (const char* step : {"evaluate.comp", "finish.comp"})
        all.push_back({step, by});
    if (mesh.scheme != Scheme::annealing)
        return;
    all.push_back({"anneal_draw.comp", ""});
    all.push_back({"anneal_select.comp", by});
    all.push_back({"anneal_flip.comp", ""});
    all.push_back({"evaluate.comp", by + " DENSE CANDIDATES"});
}

void add_surface(const SurfaceOptions& options, std::vector<JobProgram>& all) {
    const bool quadratic = options.kind != Surface::linear;
    if (quadratic)
        all.push_back({"gradients.comp", gradient_macros(options)});
    if (options.consistency > 0 && (quadratic || options.soft > 0))
        all.push_back({"net_edges.comp", surface_macros(options)});
    if (is_fitted(options))
        all.push_back({"fitted_bends.comp", bend_macros(options)});
    if (options.consistency > 0)
        all.push_back({"correct.comp", correct_macros(options)});
}

const char* bounds_macro(Bounds bounds) {
    switch (bounds) {
    case Bounds::vertices:
        return " BOUNDS_VERTICES";
    case Bounds::dark:
        return " BOUNDS_DARK";
    case Bounds::none:
        break;
    }
    return "";
}

} // namespace

std::string criterion_macros(const Criterion& by) {
    return std::string("COST_") + cost_name(by.cost) + (by.contour != 0 ? " CONTOURS" : "");
}

std::string surface_macros(const SurfaceOptions& options) {
    return std::string(options.kind == Surface::linear ? "" : "QUADRATIC ") +
           (options.soft > 0 ? "SOFT" : "") + bounds_macro(bounds_of(options));
}

std::string gradient_macros(const SurfaceOptions& options) {
    return is_fitted(options) ? "FITTED" : "";
}

std::string bend_macros(const SurfaceOptions& options) {
    return surface_macros(options) + " STORED_EDGES";
}

std::string correct_macros(const SurfaceOptions& options) {
    return surface_macros(options) + " STORED_EDGES" + (is_fitted(options) ? " FITTED" : "");
}

std::string sample_macros(const SurfaceOptions& options, int channels, int mesh) {
    return surface_macros(options) + (channels % group_size == 0 ? " WHOLE_GROUPS" : "") +
           (is_fitted(options) ? " STORED_BENDS" : "") + (mesh > 0 ? " MEAN" : "");
}

std::string unpack_macros(const Numbers& numbers) {
    return numbers.bytes == 1 ? "CODES_8" : numbers.bytes == 2 ? "CODES_16" : "";
}

std::string pack_macros(Transfer::Download back) {
    return back == Transfer::Download::codes ? "CODES" : "HALFS";
}

std::vector<JobProgram> job_programs(const Job& job, const Transfer& transfer) {
    std::vector<JobProgram> all{{"unpack_guide.comp", ""},
                                {"unpack.comp", unpack_macros(transfer.upload)}};
    add_mesh(job.mesh, all);
    add_surface(job.surface, all);
    for (int mesh = 0; mesh < std::min(job.mesh.meshes, 2); ++mesh)
        all.push_back({"sample.comp", sample_macros(job.surface, job.channels, mesh)});
    if (transfer.packed())
        all.push_back({"pack.comp", pack_macros(transfer.download)});
    return all;
}

} // namespace ddt::gl
