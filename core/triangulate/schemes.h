// SPDX-License-Identifier: Apache-2.0
// The schemes beside one_round and lawson. All add to `statistics` and end when nothing is left to
// flip or after the given number of iterations.
#pragma once

#include "core/triangulate/triangulate.h"

namespace ddt {

/// What tells the paper's parallel schemes apart.
struct Rules {
    bool by_gain;        ///< priority: the largest gain, ties to the smaller address; else the
                         ///< smallest address. (The address is the paper's edge ID, kept for life.)
    int wide_iterations; ///< iterations in which a candidate's region is that of degree 3, not 2
    bool all_rounds;     ///< accept and reject until every candidate is treated; else one round

    static constexpr int always = 1 << 30;
};

/// The rules of the options' scheme; false if it is not one of the paper's.
bool find_rules(const MeshOptions& options, Rules& rules);

/// Cervenansky et al. 2010, section 4 and figure 6. An iteration: evaluate; edges that gain more
/// than min_gain are candidates. Rounds: a candidate with the highest priority among the untreated
/// of its region is accepted; untreated candidates in the region of an accepted one are rejected.
/// Then the accepted flip.
///
/// Only edges whose gain can have changed are evaluated again (the paper's future work), so
/// Statistics::evaluations is less than the paper's, and nothing else differs.
void accept_reject(Lattice& lattice, const Criterion& criterion, float min_gain, int max_iterations,
                   const Rules& rules, Workspace& workspace, Statistics& statistics);

/// Lawson's sweeps with the look-ahead of Yu, Morse & Sederberg 2001, "Image reconstruction using
/// data-dependent triangulation": an edge that does not gain by itself is flipped together with the
/// best of its parallelogram's sides if the two flips gain together. Sequential.
void look_ahead(Lattice& lattice, const Criterion& criterion, float min_gain, int max_sweeps,
                const Workspace& workspace, Statistics& statistics);

/// Simulated annealing (Schumaker 1993, "Computing optimal triangulations using simulated
/// annealing"), in parallel: in each iteration, edges drawn at random that are outside each other's
/// 2-region flip with the probability of Metropolis et al. 1953, min(1, exp(gain / t)), while t
/// falls to 0. Begins at a mesh made by one_round and ends with another one_round.
///
/// Randomness comes from the seed, the iteration and the edge's place in the image alone: the same
/// on every machine and for every number of threads.
void annealing(Lattice& lattice, const Criterion& criterion, float min_gain, int iterations,
               uint32_t seed, Workspace& workspace, Statistics& statistics);

} // namespace ddt
