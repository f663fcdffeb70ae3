// SPDX-License-Identifier: Apache-2.0
// Flipping edges until the mesh follows the guide.
#pragma once

#include <functional>
#include <vector>

#include "core/cost/criterion.h"
#include "core/lattice/lattice.h"
#include "ddt/core.h"

namespace ddt {

/// Memory of a triangulation, kept from one tile to the next.
struct Workspace {
    struct Blocked {
        int site;    ///< a candidate that was not the best of its region,
        int blocker; ///< and a better one in it
    };
    std::vector<float> gain;             ///< a site; only meaningful for edges
    std::vector<int> dirty;              ///< edges to evaluate in this iteration
    std::vector<int> flippable;          ///< those of them that can be flipped
    std::vector<int> candidates;         ///< edges to look at in this iteration's selection
    std::vector<int> selected;           ///< edges to flip
    std::vector<Blocked> blocked;        ///< candidates that wait
    std::function<bool(float)> progress; ///< see go_on(); may be empty
    int origin_x = 0, origin_y = 0; ///< the lattice's first pixel in the image: chance is drawn by
                                    ///< an edge's place in the image, whatever tile it is in

    /// Called once an iteration by schemes: tells progress() the share that is not among the `left`
    /// of `all` things to do. False: flip no more.
    bool go_on(size_t left, size_t all) const {
        return !progress || progress(1.0f - float(left) / float(all));
    }
};

/// The threshold in use: options.min_gain or, where that is negative, the cost's own; for lawson
/// and the paper's schemes 1e-6, a bare guard against rounding.
float min_gain(const MeshOptions& options);

/// What the options' scheme judges flips by.
Criterion criterion(const MeshOptions& options);

/// The share by which the guide of mesh 0 <= index < options.meshes is blurred.
float blur_share(const MeshOptions& options, int index);

/// Whether the options' numbers are allowed; if not, `error` says which is and what it may be.
bool check_options(const MeshOptions& options, std::string& error);

/// Start a lattice as the options want it, for triangulate().
void start(Lattice& lattice, int width, int height, const float* guide, const MeshOptions& options);

/// Flip edges of a started lattice by options.scheme. Adds to `statistics`.
void triangulate(Lattice& lattice, const MeshOptions& options, Workspace& workspace,
                 Statistics& statistics);

/// Fill workspace.gain with the gains of all flippable edges of a finished mesh, no_gain (gain.h)
/// at the others.
void find_gains(const Lattice& lattice, const Criterion& criterion, Workspace& workspace);

/// Sequential local optimization (Lawson 1977): sweeps over all edges in address order; an edge
/// that gains flips at once; until a sweep flips nothing. The reference.
void lawson(Lattice& lattice, const Criterion& criterion, float min_gain, int max_sweeps,
            const Workspace& workspace, Statistics& statistics);

/// The default parallel scheme. An iteration: evaluate the gains of all edges that a flip touched
/// (at first, of all); select every edge whose gain exceeds min_gain and is the largest of its
/// 2-region, the smaller address winning a tie; flip the selected.
///
/// Two edges outside each other's 2-region never write the same record, nor does one's flip change
/// the other's gain, so the order of flips within an iteration is immaterial, and every flip lowers
/// the total cost by its gain. Leaves workspace.gain as find_gains() would.
void one_round(Lattice& lattice, const Criterion& criterion, float min_gain, int max_iterations,
               Workspace& workspace, Statistics& statistics);

} // namespace ddt
