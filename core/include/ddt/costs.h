// SPDX-License-Identifier: Apache-2.0
// The list of costs: the one place, beside its formula in core/cost/cost-inl.h, that names a cost.
#pragma once

/// X(name, Class, min_gain, temperature, help): `name` is the enumerator and the option's value,
/// `Class` the formula's class; a flip of Scheme::one_round or look_ahead must gain more than
/// `min_gain`, Scheme::annealing starts at `temperature`, both in units of the cost; `help` is for
/// people. A cost without a class in core/cost/cost-inl.h does not compile.
///
/// abn's min_gain is more than a guard against rounding: small gains are noise, and leaving them
/// alone costs no picture quality while it halves the work.
#define DDT_COSTS(X)                                                                               \
    X(abn, Abn, 5e-3f, 0.1f, "What the mesh bends over the edge: the angle between normals.")      \
    X(scf, Scf, 1e-6f, 2e-2f, "Sederberg's cost function, the paper's own.")                       \
    X(jnd, Jnd, 1e-6f, 0.1f, "Dyn, Levin & Rippa: the jump of the normal derivative.")             \
    X(dlp, Dlp, 1e-6f, 0.1f, "Dyn, Levin & Rippa: the deviations from linear polynomials.")        \
    X(dp, Dp, 1e-6f, 0.5f, "Dyn, Levin & Rippa: the distances from planes.")
