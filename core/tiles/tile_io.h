// What goes into a tile and out of it, for all devices alike.
#pragma once

#include <vector>

#include "core/sample/evaluate.h"
#include "core/sample/locate.h"
#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt {

/// Output pixels whose positions the tile may serve; empty if the mapping shows none of it.
Rect reach_of(const Tile& tile, const Rect& window, const Mapping& mapping);

/// Whether a position, not outside the window, is the tile's to sample.
bool serves(const Tile& tile, const Position& p);

/// A position in the lattice of the tile.
Point local(const Tile& tile, const Position& p);

/// Read the tile's pixels. A picture one pixel wide or high is widened to two by repeating it: a
/// lattice has at least 2 x 2; `width` and `height` receive its size.
bool read_tile(Source& source, const Tile& tile, int channels, std::vector<float>& values,
               std::vector<float>& guide, int& width, int& height);

/// Channels are worked on in groups of group_size.
int group_count(int channels);
int channels_in_group(int channels, int group);
/// Which channels of a job's group are Channel::nearest.
NearestMask nearest_mask(const Job& job, int group);

} // namespace ddt
