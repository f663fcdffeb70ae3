// SPDX-License-Identifier: Apache-2.0
// Flipping edges until the mesh follows the guide.
#pragma once

#include "core/base/memory/arena.h"
#include "core/cost/criterion.h"
#include "core/lattice/lattice.h"
#include "ddt/core.h"
#include "ddt/progress.h"

namespace ddt {

/// Memory of a triangulation, kept from one tile to the next.
struct Workspace {
    struct Blocked {
        int site;    ///< a candidate that was not the best of its region,
        int blocker; ///< and a better one in it
    };
    ArenaVector<int> dirty;         ///< edges to evaluate in this iteration
    ArenaVector<int> flippable;     ///< those of them that can be flipped
    ArenaVector<int> candidates;    ///< edges to look at in this iteration's selection
    ArenaVector<int> selected;      ///< edges to flip
    ArenaVector<Blocked> blocked;   ///< candidates that wait
    ArenaVector<Blocked> again;     ///< those whose blockers are evaluated again
    ProgressCallback progress;      ///< see go_on(); may be empty
    int origin_x = 0, origin_y = 0; ///< the lattice's first pixel in the image: chance is drawn by
                                    ///< an edge's place in the image, whatever tile it is in

    Workspace() = default;
    /// With lists in an arena, which is not cleared while this is there.
    explicit Workspace(Arena& arena)
        : dirty(&arena), flippable(&arena), candidates(&arena), selected(&arena), blocked(&arena),
          again(&arena) {}

    /// Take the memory for one_round's lists of most meshes of so many vertices: as long as they
    /// get in noise.
    void reserve(size_t vertices) {
        candidates.reserve(vertices * 5 / 4); // all that is touched
        selected.reserve(vertices / 4);
        blocked.reserve(vertices * 9 / 16);
        again.reserve(vertices / 8);
    }
    /// The bytes of that.
    static constexpr size_t memory(size_t vertices) {
        return vertices * (5 + 1) / 4 * sizeof(int) + vertices * (9 + 2) / 16 * sizeof(Blocked) +
               4 * Arena::line;
    }
    /// The same of the paper's schemes, which begin with all edges, three a vertex.
    void reserve_for_all(size_t vertices) {
        dirty.reserve(vertices * 3);
        flippable.reserve(vertices * 3);
        candidates.reserve(vertices * 2);
        selected.reserve(vertices / 2);
        blocked.reserve(vertices * 2);
    }
    static constexpr size_t memory_for_all(size_t vertices) {
        return vertices * (6 * 2 + 5) / 2 * sizeof(int) + vertices * 2 * sizeof(Blocked) +
               5 * Arena::line;
    }

    /// Called once an iteration by schemes: tells progress() the share that is not among the `left`
    /// of `all` things to do. False: flip no more.
    bool go_on(size_t left, size_t all) const {
        return !progress || progress(1.0f - float(left) / float(all));
    }
};

/// About the bytes that triangulate() takes of a mesh of so many vertices.
struct SchemeMemory {
    size_t lists = 0; ///< of the workspace
    size_t other = 0; ///< on the heap
};
SchemeMemory scheme_memory(Scheme scheme, size_t vertices);

/// The threshold in use: options.min_gain or, where that is negative, the cost's own; for lawson
/// and the paper's schemes 1e-6, a bare guard against rounding.
float min_gain(const MeshOptions& options);

/// What the options' scheme judges flips by.
Criterion criterion(const MeshOptions& options);

/// The share by which the guide of mesh 0 <= index < options.meshes is blurred.
float blur_share(const MeshOptions& options, int index);

/// Start a lattice as the options want it, for triangulate().
void start(Lattice& lattice, int width, int height, const float* guide, const MeshOptions& options);

/// Flip edges of a started lattice by options.scheme. Adds to `statistics`.
void triangulate(Lattice& lattice, const MeshOptions& options, Workspace& workspace,
                 Statistics& statistics);

/// Find the gains of all edges that can be flipped.
void find_all_gains(Lattice& lattice, const Criterion& criterion);

} // namespace ddt
