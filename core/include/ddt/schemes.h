// SPDX-License-Identifier: Apache-2.0
// The list of schemes: the one place that names a scheme. What each does is told by its row;
// sources are in core/triangulate/.
#pragma once

/// X(enumerator, name, help): `name` is the option's value. A scheme without a case in
/// core/triangulate/run_scheme.h does not compile.
#define DDT_SCHEMES(X)                                                                             \
    X(one_round, "one-round",                                                                      \
      "Parallel: flip all edges at once that gain most in their neighbourhood.")                   \
    X(lawson, "lawson", "Sequential: flip one edge after the other; the slow reference.")          \
    X(basic, "basic", "The paper's: edges with the smallest addresses, accepted in rounds.")       \
    X(exproi, "exproi", "The paper's: `basic` with the wide region.")                              \
    X(maxgain, "maxgain", "The paper's: edges with the largest gains, accepted in rounds.")        \
    X(exproi_maxgain, "exproi-maxgain", "The paper's: `maxgain` with the wide region.")            \
    X(exproi_n_maxgain, "exproi2-maxgain",                                                         \
      "The paper's: `maxgain` with the wide region for the first 2 iterations (or N).")            \
    X(look_ahead, "look-ahead",                                                                    \
      "As `lawson`, and pairs of flips that pay only together: a cheaper mesh, slowly.")           \
    X(annealing, "annealing",                                                                      \
      "Parallel: flips that lose too, at random: the cheapest mesh, very slowly.")                 \
    X(pixel, "pixel", "Keep the starting mesh.")
