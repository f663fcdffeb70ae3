#include "core/triangulate/triangulate.h"

#include "core/cost/cost.h"
#include "core/triangulate/gain.h"

namespace ddt {

float min_gain(const MeshOptions& options) {
    return options.min_gain < 0 ? default_min_gain(options.cost) : options.min_gain;
}

void triangulate(Lattice& lattice, const MeshOptions& options, Workspace& workspace,
                 Statistics& statistics) {
    statistics.pixels += int64_t(lattice.width()) * lattice.height();
    switch (options.scheme) {
    case Scheme::pixel:
        break;
    case Scheme::lawson:
        lawson(lattice, options.cost, min_gain(options), options.max_iterations, statistics);
        break;
    case Scheme::one_round:
        one_round(lattice, options.cost, min_gain(options), options.max_iterations, workspace,
                  statistics);
        break;
    }
}

void find_gains(const Lattice& lattice, Cost cost, Workspace& w) {
    w.gain.resize(lattice.size());
    w.flippable.clear();
    lattice.each_edge([&](int m) {
        if (lattice.edge(m).flippable())
            w.flippable.push_back(m);
    });
    gains(lattice, cost, w.flippable.data(), w.flippable.size(), w.gain.data());
}

} // namespace ddt
