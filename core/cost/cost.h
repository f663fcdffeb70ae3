// SPDX-License-Identifier: Apache-2.0
// The costs of a mesh edge. The formulas are in cost-inl.h.
#pragma once

#include "core/base/arith.h"
#include "ddt/core.h"

namespace ddt {

/// A cost's entry in the list of ddt/costs.h, without formula.
struct CostTraits {
    float min_gain, temperature;
};

inline CostTraits traits(Cost cost) {
    switch (cost) {
#define DDT_TRAITS(name, Class, min_gain, temperature, ...)                                        \
    case Cost::name:                                                                               \
        return {min_gain, temperature};
        DDT_COSTS(DDT_TRAITS)
#undef DDT_TRAITS
    }
    return {};
}

namespace scalar {
#include "core/cost/cost-inl.h"
} // namespace scalar

/// Call f with the scalar twin of `cost`: dispatch(cost, [&](auto c) { ... decltype(c) ... }).
template <class F>
auto dispatch(Cost cost, F&& f) {
    switch (cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        return f(scalar::Class<float>());
        DDT_COSTS(DDT_CALL)
#undef DDT_CALL
    }
    __builtin_unreachable();
}

} // namespace ddt
