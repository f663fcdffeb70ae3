// SPDX-License-Identifier: Apache-2.0
// What goes into a tile and out of it, for all devices alike.
#pragma once

#include <cstddef>
#include <vector>

#include "core/lattice/locate.h"
#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt {

/// All output pixels that the mapping shows something in.
Rect output_of(const Mapping& mapping);

/// Output pixels whose positions the tile may serve; empty if the mapping shows none of it.
Rect reach_of(const Tile& tile, const Rect& window, const Mapping& mapping);

/// Rows of the largest of these among the window's tiles.
int most_rows_of_a_tile(const Rect& window, const Mapping& mapping);

/// The block of the window's tiles outside which the mapping shows nothing of it.
Grid shown_tiles(const Rect& window, const Mapping& mapping);

/// Whether a position, not outside the window, is the tile's to sample.
bool serves(const Tile& tile, const Position& p);
/// Whether it lies in the tile's columns, below its rows.
bool serves_below(const Tile& tile, const Position& p);

/// A position in the lattice of the tile; one outside its pixels is moved to the nearest inside, so
/// that no mapping leads out of the lattice.
Point local(const Tile& tile, const Position& p);
/// Whether b is so near to `a` that sampling can follow a row from the one to the other, by exact
/// arithmetic in 32 bits.
bool follows(const Point& a, const Point& b);

/// Numbers nearer to zero than this become zero when a tile is read (and guides' than least_guide).
/// So hardly anything that is computed from them comes near the denormal floats, which some devices
/// keep and others take for zero: products with a weight by a large gradient, which shaders make
/// zero themselves (without_denormals() in shaders/arith.glsl), and sums of them.
constexpr float least_value = 0x1p-80f;

/// Read the tile's pixels, its guide cleaned (clean_guide()), small numbers zeroed as said above
/// (but not in nearest channels). A picture one pixel wide or high is widened to two by repeating
/// it: a lattice has at least 2 x 2; `width` and `height` receive its size. `values` and `guide`
/// have room for as many pixels.
bool read_tile(Source& source, const Tile& tile, const Job& job, float* values, float* guide,
               int& width, int& height);
/// The same into vectors that become as long as that.
bool read_tile(Source& source, const Tile& tile, const Job& job, std::vector<float>& values,
               std::vector<float>& guide, int& width, int& height);
/// Size of the lattice that a tile's pixels become.
int lattice_width(const Tile& tile);
int lattice_height(const Tile& tile);

} // namespace ddt
