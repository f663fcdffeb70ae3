// SPDX-License-Identifier: Apache-2.0
// Least squares of the surface's weights on the pixels of pictures. The surface is linear in them.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/fit/scene.h"

namespace fit {

/// All weights as one vector, in FittedWeights' order.
constexpr int unknowns = int(sizeof(ddt::FittedWeights) / sizeof(float));

struct NormalEquations {
    std::vector<double> matrix = std::vector<double>(size_t(unknowns) * unknowns); ///< lower half
    std::vector<double> right = std::vector<double>(unknowns);

    void add(const NormalEquations& other);
    /// Add one in `every` of the scene's pixels in all channels, chosen at random by `seed`. Each
    /// scene counts `weight`, whatever its size, in units of its own mean square error. Black and
    /// white pixels which the weights so far, if there are any, put past black or white are right
    /// as they are, once cut off: they are left out.
    void add(const Scene& scene, double weight, unsigned every, uint32_t seed,
             const ddt::FittedWeights* so_far);
    /// Find all weights but FittedWeights::bound. `ridge` is a share of the diagonal that is added
    /// to it.
    void solve_plain(double ridge, ddt::FittedWeights& weights) const;
    /// Find FittedWeights::bound, the others being as they are.
    void solve_bound(double ridge, ddt::FittedWeights& weights) const;

private:
    void solve(const std::vector<int>& wanted, double ridge, float* weights) const;
};

/// The picture that the weights make, its clamps included: display values, not rounded.
metrics::Image enlarge(const Scene& scene, const ddt::FittedWeights& weights);

} // namespace fit
