// SPDX-License-Identifier: Apache-2.0
// Where a result that is made piece by piece is best cut.
#pragma once

#include <cstddef>
#include <vector>

#include "ddt/mapping.h"

namespace ddt {

/// Where along an axis pieces begin, and where the last one ends: at the first pixel that lies on
/// the next tile of the source's mesh, so that no tile is worked on for two pieces, unless that
/// makes them longer than `most` and a quarter, as the first one of a tile that fills `most` is a
/// little. No shorter than `least`, but for the last one and parts of a tile. Where they begin
/// changes no pixel.
std::vector<int> cuts_between_tiles(const ResizeMapping::Axis& axis, int least, int most);

/// The index of the piece that pixel i lies in.
size_t piece_of(const std::vector<int>& cuts, int i);

} // namespace ddt
