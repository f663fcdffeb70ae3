// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/triangulate.h"

#include <algorithm>
#include <limits>

#include "core/base/float_mode.h"
#include "core/cost/cost.h"
#include "core/triangulate/run_scheme.h"

namespace ddt {

SchemeMemory scheme_memory(Scheme scheme, size_t vertices) {
    const size_t sites = 4 * vertices;
    switch (scheme) {
    case Scheme::one_round:
        return {Workspace::memory(vertices), 0};
    case Scheme::annealing:
        return {Workspace::memory(vertices), Annealing<Lattice>::memory(sites, vertices)};
    case Scheme::look_ahead:
        return {0, sites};
    case Scheme::basic:
    case Scheme::exproi:
    case Scheme::maxgain:
    case Scheme::exproi_maxgain:
    case Scheme::exproi_n_maxgain:
        return {Workspace::memory_for_all(vertices), sites};
    case Scheme::lawson:
    case Scheme::pixel:
        break;
    }
    return {};
}

float min_gain(const MeshOptions& options) {
    constexpr float guard = 1e-6f;
    if (options.min_gain >= 0)
        return options.min_gain;
    switch (options.scheme) {
    case Scheme::one_round:
    case Scheme::look_ahead:
    case Scheme::annealing:
    case Scheme::pixel:
        return traits(options.cost).min_gain;
    case Scheme::lawson:
    case Scheme::basic:
    case Scheme::exproi:
    case Scheme::maxgain:
    case Scheme::exproi_maxgain:
    case Scheme::exproi_n_maxgain:
        return guard;
    }
    return guard;
}

float blur_share(const MeshOptions& options, int index) {
    const DenormalsAreZero as_on_gpus;
    if (options.meshes == 1)
        return options.blur;
    const float least = std::max(options.blur - mesh_spread, 0.0f);
    const float most = std::min(options.blur + mesh_spread, largest_blur);
    return least + (most - least) * (float(index) / float(options.meshes - 1));
}

std::optional<Rules> find_rules(const MeshOptions& options) {
    switch (options.scheme) {
    case Scheme::basic:
        return Rules{false, 0};
    case Scheme::exproi:
        return Rules{false, Rules::always};
    case Scheme::maxgain:
        return Rules{true, 0};
    case Scheme::exproi_maxgain:
        return Rules{true, Rules::always};
    case Scheme::exproi_n_maxgain:
        return Rules{true, options.wide_iterations};
    case Scheme::one_round:
    case Scheme::lawson:
    case Scheme::look_ahead:
    case Scheme::annealing:
    case Scheme::pixel:
        return {};
    }
    return {};
}

Criterion criterion(const MeshOptions& options) {
    return {options.cost, options.contour};
}

void start(Lattice& lattice, int width, int height, const float* guide,
           const MeshOptions& options) {
    lattice.start(width, height, guide, options.start == Start::flat, options.contour != 0);
}

void triangulate(Lattice& lattice, const MeshOptions& options, Workspace& workspace,
                 Statistics& statistics) {
    run_scheme(lattice, options, workspace, statistics);
}

void find_all_gains(Lattice& lattice, const Criterion& criterion) {
    Workspace workspace;
    evaluate_all(lattice, criterion, std::numeric_limits<float>::infinity(), workspace);
}

} // namespace ddt
