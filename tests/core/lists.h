// SPDX-License-Identifier: Apache-2.0
// All that the lists of costs, schemes and surfaces have.
#pragma once

#include <initializer_list>
#include <vector>

#include "core/surface/bounds.h"
#include "ddt/core.h"
#include "tests/core/plain.h"

namespace ddt::test {

inline constexpr Cost all_costs[] = {
#define DDT_COST(name, ...) Cost::name,
    DDT_COSTS(DDT_COST)
#undef DDT_COST
};

inline constexpr Scheme all_schemes[] = {
#define DDT_SCHEME(name, ...) Scheme::name,
    DDT_SCHEMES(DDT_SCHEME)
#undef DDT_SCHEME
};

inline constexpr Bounds all_bounds[] = {Bounds::vertices, Bounds::dark, Bounds::none};
inline constexpr Surface both_surfaces[] = {Surface::linear, Surface::patch};

/// Both surfaces with so many rounds of correction each, with and without soft edges; where one
/// round is among them, fitted vertices and bends too.
inline std::vector<SurfaceOptions> surfaces_with(std::initializer_list<int> rounds) {
    std::vector<SurfaceOptions> all;
    for (const Surface kind : both_surfaces)
        for (const int consistency : rounds)
            for (const float soft : {0.0f, 0.3f}) {
                SurfaceOptions s = plain_surface(kind);
                s.consistency = consistency;
                s.soft = soft;
                all.push_back(s);
                s.fitted = kind == Surface::patch && consistency == 1;
                if (s.fitted)
                    all.push_back(s);
            }
    return all;
}

} // namespace ddt::test
