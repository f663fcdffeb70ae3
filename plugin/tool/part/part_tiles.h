// SPDX-License-Identifier: Apache-2.0
// The source's tiles that make a part.
#pragma once

#include <OpenImageIO/imageio.h>

#include "core/tiles/grid.h"
#include "ddt/mapping.h"
#include "ddt/rect.h"
#include "plugin/tool/part/part.h"

namespace ddt::tool {

/// The tiles of a part, row by row, and the result's pixels that are made from them.
class PartTiles {
public:
    PartTiles(const Grid& grid, const OIIO::ImageSpec& from, const OIIO::ImageSpec& whole,
              const Part& part);

    int rows() const { return m_tiles.height(); }
    const Rect& pixels() const { return m_pixels; }
    /// Rows of pixels before this are made from rows of tiles up to this one.
    int end(int row) const { return made_from(row_of(row)).y1; }
    /// The source's pixels that a row of tiles is made from.
    Rect source(int row) const;

private:
    Rect row_of(int row) const;
    Rect made_from(const Rect& tiles) const;

    const Grid m_grid;
    const ResizeMapping::Axis m_x, m_y;
    const Rect m_tiles, m_pixels;
};

} // namespace ddt::tool
