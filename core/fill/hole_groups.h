// SPDX-License-Identifier: Apache-2.0
// Which missing pixels are filled over one mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddt/rect.h"

namespace ddt {

/// Missing pixels that share a mesh.
struct HoleGroup {
    Rect box;                   ///< the least that holds them
    std::vector<size_t> pixels; ///< their places in the image, row by row
    size_t rim = 0;             ///< sides of theirs beyond which a pixel is there
    bool deep = false;          ///< whether all pixels round one of them are missing
    int reach = 0; ///< along both axes, how far beyond them what else is missing counts
};

/// Holes of up to this many pixels each way share meshes.
constexpr int hole_block = 64;

/// `pixels`, places in an image whose bytes of `missing` are not 0, as a group without reach.
HoleGroup group_of(std::vector<size_t> pixels, const uint8_t* missing, int width, int height);

/// Every missing pixel of an image (its byte is not 0) in one group. A hole is what touches, along
/// sides or at corners. Holes of up to hole_block x hole_block pixels whose boxes begin in the same
/// block of that size are one group, so that where single pixels are missing all over an image
/// meshes stay small, and can be made side by side. A larger hole is cut where it is thin
/// (hole_pieces.h), and each piece a group of its own. The groups are those of the image alone.
std::vector<HoleGroup> group_holes(const uint8_t* missing, int width, int height);

} // namespace ddt
