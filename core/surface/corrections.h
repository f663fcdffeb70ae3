// SPDX-License-Identifier: Apache-2.0
// Whether, and how much, a surface's vertices are corrected.
#pragma once

#include <algorithm>

#include "ddt/core.h"

namespace ddt {

/// Whether a surface is made of fitted vertices and bends (core/surface/fitted/fitted.h), in place
/// of rounds of consistency.
inline bool is_fitted(const SurfaceOptions& surface) {
    return surface.fitted && surface.consistency > 0 && surface.kind == Surface::patch;
}

/// Whether vertices are corrected by rounds of consistency before edges are made.
inline bool is_corrected(const SurfaceOptions& surface) {
    return surface.consistency > 0 && !is_fitted(surface);
}

/// How much of a correction is made, 0 to 1, where about so many output pixels lie across a source
/// pixel. Those of a source pixel are to have its value as their mean. Read at positions d apart
/// about its centre, what a surface curves there adds to that mean in proportion to 1 - d^2: all
/// where they are many, nothing where one is read. 2 - 2 d is near that from 1 to 2, and nearer to
/// what is best for photographs (docs/quality.md). NaN counts as many.
inline float correction_strength(const Mapping::Scale& scale) {
    const auto along = [](double n) { return n < 2 ? 2 - 2 / std::max(n, 1.0) : 1.0; };
    return float((along(scale.x) + along(scale.y)) / 2);
}

/// How a vertex is corrected.
struct Correction {
    float limit = 0; ///< SurfaceOptions::limit and clipped
    bool clipped = false;
    float strength = 1; ///< correction_strength()
};

/// Whether a surface depends on the finished mesh's gains.
inline bool wants_gains(const SurfaceOptions& surface) {
    return surface.soft > 0 || is_fitted(surface);
}

} // namespace ddt
