// SPDX-License-Identifier: Apache-2.0
// How a surface's options say that its vertices are corrected.
#pragma once

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

/// Whether a surface depends on the finished mesh's gains.
inline bool wants_gains(const SurfaceOptions& surface) {
    return surface.soft > 0 || is_fitted(surface);
}

} // namespace ddt
