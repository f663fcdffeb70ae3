// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/triangulate.h"

#include <algorithm>

#include "core/cost/cost.h"
#include "core/triangulate/run_scheme.h"

namespace ddt {

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
    if (options.meshes == 1)
        return options.blur;
    const float least = std::max(options.blur - mesh_spread, 0.0f);
    const float most = std::min(options.blur + mesh_spread, 0.25f);
    return least + (most - least) * (float(index) / float(options.meshes - 1));
}

bool check_options(const MeshOptions& options, std::string& error) {
    if (options.max_iterations < 0 || options.max_iterations > 250)
        error = "ddt: max_iterations must be 0 to 250";
    else if (!(options.blur >= 0 && options.blur <= 0.25f))
        error = "ddt: blur must be 0 to 1/4";
    else if (options.meshes < 1 || options.meshes > most_meshes)
        error = "ddt: meshes must be 1 to " + std::to_string(most_meshes);
    else
        return true;
    return false;
}

bool find_rules(const MeshOptions& options, Rules& rules) {
    switch (options.scheme) {
    case Scheme::basic:
        rules = {false, 0, true};
        return true;
    case Scheme::exproi:
        rules = {false, Rules::always, true};
        return true;
    case Scheme::maxgain:
        rules = {true, 0, true};
        return true;
    case Scheme::exproi_maxgain:
        rules = {true, Rules::always, true};
        return true;
    case Scheme::exproi_n_maxgain:
        rules = {true, options.wide_iterations, true};
        return true;
    default:
        return false;
    }
}

void triangulate(Lattice& lattice, const MeshOptions& options, Workspace& workspace,
                 Statistics& statistics) {
    run_scheme(lattice, options, workspace, statistics);
}

void find_gains(const Lattice& lattice, Cost cost, Workspace& w) {
    w.gain.resize(lattice.size());
    w.flippable.clear();
    lattice.each_edge([&](int m) {
        w.gain[size_t(m)] = no_gain;
        if (lattice.flippable(m))
            w.flippable.push_back(m);
    });
    gains(lattice, cost, w.flippable.data(), w.flippable.size(), w.gain.data());
}

} // namespace ddt
