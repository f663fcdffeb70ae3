// SPDX-License-Identifier: Apache-2.0
// What a surface with soft edges is cut off at, and softness bounded by (control_net.h).
#pragma once

#include "core/surface/corrections.h"
#include "ddt/options.h"

namespace ddt {

enum class Bounds {
    vertices, ///< the range of a triangle's vertices
    dark,     ///< where none of these is negative, half the smallest: every blend of planes over
              ///< such values leaves that. What bends add would, beside a light a thousand times as
              ///< bright, be black
    none,
};

/// Vertices that are the pixels themselves bound the surface, corrected ones do not; what is cut
/// off afterwards need not be bounded before. Where nothing but rounding takes the surface past its
/// vertices, that is taken off.
inline Bounds bounds_of(const SurfaceOptions& surface) {
    const bool within = surface.soft == 0 && !is_fitted(surface);
    return surface.consistency == 0 || within ? Bounds::vertices
           : surface.clipped                  ? Bounds::none
                                              : Bounds::dark;
}

} // namespace ddt
