// SPDX-License-Identifier: Apache-2.0
// The fans of vertices beside crossed cells, kept for whoever asks for the same row next.
#pragma once

#include <vector>

#include "core/lattice/fans.h"
#include "core/lattice/row_ring.h"

namespace ddt {

/// Of the rows that were asked for last. Rounds of corrections, and groups of channels, are some
/// rows apart and ask for the same.
class FanRows {
public:
    /// Start on a lattice, whose divisions and first edges have been found. rows: to be kept, one
    /// at least.
    void begin(const Lattice& lattice, int rows);

    /// Of the vertices beside crossed cells in columns x0 .. x1 - 1, or more, of row y, from left
    /// to right; none of them are on the hull's rim. Until another row is asked for.
    const Fans& row(int y, int x0, int x1);

    /// About the bytes that so many rows of pixels take where all cells are crossed.
    static size_t memory(int width, int rows);

private:
    void find(int y, int x0, int x1, Fans& fans);

    const Lattice* m_lattice = nullptr;
    RowRing<Fans> m_rows;
    std::vector<int> m_columns;
    std::vector<Vec> m_walked;
};

} // namespace ddt
