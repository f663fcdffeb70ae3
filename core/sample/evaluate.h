// SPDX-License-Identifier: Apache-2.0
// Reading the surface at a row of positions.
//
// Row by row, where positions form no grid or a channel is Channel::nearest: locate_row()
// (locate_row.h) finds the triangle or plain cell of each position, evaluate_row() the values.
//
// Where they form a grid, by blocks of rows that lie in one row of cells: locate_block() says which
// cells are made how, and evaluate_block() has each kind made by a function of its own:
//   LocatedBlock::phases    neighbouring cells in which positions lie alike, all as if they were
//                           plain: evaluate_phases() (evaluate_phases.cpp), several cells in a
//                           vector
//   LocatedBlock::ranges    other cells: evaluate_ranges() (evaluate.cpp), cell by cell, several
//                           positions in a vector
//   LocatedBlock::crossed   crossed cells in which positions lie alike: evaluate_crossed()
//                           (evaluate_crossed.cpp), over what evaluate_phases() left there
#pragma once

#include "core/sample/locate_row.h"
#include "core/surface/control_net.h"

namespace ddt {

/// Which channels of a group are Channel::nearest, one bit each.
using NearestMask = unsigned;

/// Where a group's values go: `count` channels of position i of row r to
/// out[r * row + i * channels + first_channel] and on.
struct GroupOutput {
    float* out;
    size_t row;   ///< floats from a row to the next, where there are several
    int channels; ///< floats a position has in `out`, of which the group's are
    int first_channel, count;

    /// The group's first channel at a position of the first row.
    float* at(int position) const {
        return out + size_t(position) * size_t(channels) + first_channel;
    }
};

/// Evaluate a group's surface at a located row. Up to row_padding floats after the row's last are
/// overwritten.
///
/// Every value is clamped to what bounds the net (Bounds), by Bounds::vertices down to the last bit
/// of rounding; a vertex with weight 0 contributes exactly nothing, even if it is not finite; NaN
/// results have the bits 0x7fc00000, zeros no sign.
void evaluate_row(const ControlNet& net, Surface surface, NearestMask nearest,
                  const LocatedRow& row, const GroupOutput& to);

/// The same for a block's rows, nothing past their ends overwritten; for groups that have no
/// Channel::nearest.
void evaluate_block(const ControlNet& net, Surface surface, const Columns& columns,
                    const LocatedBlock& block, const GroupOutput& to);

/// Running means over surfaces, n of them: include the surface whose values are `last` with the
/// weight share = 1 / (number of surfaces, this one included).
void add_to_mean(const float* last, size_t n, float share, float* mean);

} // namespace ddt
