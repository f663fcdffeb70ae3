// SPDX-License-Identifier: Apache-2.0
// The schemes. All add to `statistics` and end when nothing is left to flip or after the given
// number of iterations.
//
// A scheme is a template over the mesh it flips: a Lattice, whose vertices are pixels, or a
// TinMesh, whose vertices are any points (core/tin/tin_mesh.h). Edges are ints below mesh.size(),
// each kept for life; smaller comes first. The definitions are in the header of the scheme's name.
#pragma once

#include <optional>

#include "core/triangulate/triangulate.h"

namespace ddt {

/// Sequential local optimization (Lawson 1977): sweeps over all edges in address order; an edge
/// that gains flips at once; until a sweep flips nothing. The reference.
template <class Mesh>
void lawson(Mesh& mesh, const Criterion& criterion, float min_gain, int max_sweeps,
            const Workspace& workspace, Statistics& statistics);

/// The default parallel scheme. An iteration: evaluate the gains of all edges that a flip touched
/// (at first, of all); select every edge whose gain exceeds min_gain and is the largest of its
/// 2-region, the smaller address winning a tie; flip the selected.
///
/// Two edges outside each other's 2-region never write the same record, nor does one's flip change
/// the other's gain, so the order of flips within an iteration is immaterial, and every flip lowers
/// the total cost by its gain. Leaves all edges with their gains.
template <class Mesh>
void one_round(Mesh& mesh, const Criterion& criterion, float min_gain, int max_iterations,
               Workspace& workspace, Statistics& statistics);

/// What tells the paper's parallel schemes apart.
struct Rules {
    bool by_gain;        ///< priority: the largest gain, ties to the smaller address; else the
                         ///< smallest address. (The address is the paper's edge ID, kept for life.)
    int wide_iterations; ///< iterations in which a candidate's region is that of degree 3, not 2

    static constexpr int always = 1 << 30;
};

/// The rules of the options' scheme; none if it is not one of the paper's.
std::optional<Rules> find_rules(const MeshOptions& options);

/// Cervenansky et al. 2010, section 4 and figure 6. An iteration: evaluate; edges that gain more
/// than min_gain are candidates. Rounds: a candidate with the highest priority among the untreated
/// of its region is accepted; untreated candidates in the region of an accepted one are rejected.
/// Then the accepted flip.
///
/// Only edges whose gain can have changed are evaluated again (the paper's future work), so
/// Statistics::evaluations is less than the paper's, and nothing else differs.
template <class Mesh>
void accept_reject(Mesh& mesh, const Criterion& criterion, float min_gain, int max_iterations,
                   const Rules& rules, Workspace& workspace, Statistics& statistics);

/// Lawson's sweeps with the look-ahead of Yu, Morse & Sederberg 2001, "Image reconstruction using
/// data-dependent triangulation": an edge that does not gain by itself is flipped together with the
/// best of its parallelogram's sides if the two flips gain together. Sequential.
template <class Mesh>
void look_ahead(Mesh& mesh, const Criterion& criterion, float min_gain, int max_sweeps,
                const Workspace& workspace, Statistics& statistics);

/// Simulated annealing (Schumaker 1993, "Computing optimal triangulations using simulated
/// annealing"), in parallel: in each iteration, edges drawn at random that are outside each other's
/// 2-region flip with the probability of Metropolis et al. 1953, min(1, exp(gain / t)), while t
/// falls to 0. Begins at a mesh made by one_round and ends with another one_round.
///
/// Randomness comes from the seed, the iteration and the edge's place in the image alone: the same
/// on every machine and for every number of threads.
template <class Mesh>
void annealing(Mesh& mesh, const Criterion& criterion, float min_gain, int iterations,
               uint32_t seed, Workspace& workspace, Statistics& statistics);

} // namespace ddt
