// The costs of a mesh edge. The formulas are in cost-inl.h.
#pragma once

#include "core/arith/arith.h"
#include "ddt/core.h"

namespace ddt {

/// A flip must gain more than this where MeshOptions::min_gain is negative.
///
/// For abn it is more than a guard against rounding: small gains are noise, and leaving them alone
/// costs no picture quality while it halves the work. scf keeps a bare guard.
inline float default_min_gain(Cost cost) {
    return cost == Cost::abn ? 5e-3f : 1e-6f;
}

namespace scalar {
#include "core/cost/cost-inl.h"
} // namespace scalar

/// Call f with the scalar twin of `cost`: dispatch(cost, [&](auto c) { ... decltype(c) ... }).
template <class F>
auto dispatch(Cost cost, F&& f) {
    switch (cost) {
    case Cost::scf:
        return f(scalar::Scf<float>());
    case Cost::abn:
    default:
        return f(scalar::Abn<float>());
    }
}

} // namespace ddt
