// SPDX-License-Identifier: Apache-2.0
// Cutting large holes where they are thin.
#pragma once

#include <cstdint>
#include <vector>

#include "core/fill/hole_groups.h"

namespace ddt {

/// A hole's pieces. What lies across a thin part depends on what is near it alone, while a mesh of
/// all that is about a long and bent hole spans everything between its parts too, in time that
/// grows with the square of its length.
///
/// The hole's box is cut into equal blocks of at most 128 x 128 pixels, and a piece is what the
/// hole has in one of them; but blocks near a part that is thick, with more than 8 pixels along
/// both axes to the nearest that is there, stay together, and are cut again by the same rule with
/// every length doubled. The mesh of a piece goes on for twice the thickness (HoleGroup::reach).
///
/// `hole`: all of it, its pixels in any order. `depth`: a byte for each pixel of the
/// image, not 0 at the hole's, 0 at those that touch it; the hole's are written.
std::vector<HoleGroup> cut_hole(HoleGroup hole, const uint8_t* missing, int width, int height,
                                std::vector<uint8_t>& depth);

} // namespace ddt
