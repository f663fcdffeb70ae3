// SPDX-License-Identifier: Apache-2.0
// The list of costs: the one place, beside its formula in core/cost/cost-inl.h, that names a cost.
#pragma once

/// X(name, Class, min_gain, temperature): `name` is the enumerator and the option's value, `Class`
/// the formula's class; a flip of Scheme::one_round or look_ahead must gain more than `min_gain`,
/// Scheme::annealing starts at `temperature`, both in units of the cost.
///
/// abn's min_gain is more than a guard against rounding: small gains are noise, and leaving them
/// alone costs no picture quality while it halves the work.
#define DDT_COSTS(X)                                                                               \
    X(abn, Abn, 5e-3f, 0.1f)                                                                       \
    X(scf, Scf, 1e-6f, 2e-2f)                                                                      \
    X(jnd, Jnd, 1e-6f, 0.1f)                                                                       \
    X(dlp, Dlp, 1e-6f, 0.1f)                                                                       \
    X(dp, Dp, 1e-6f, 0.5f)
