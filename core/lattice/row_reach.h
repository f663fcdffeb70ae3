// SPDX-License-Identifier: Apache-2.0
// How far a mesh ties rows of pixels to those above and below them.
#pragma once

#include <vector>

#include "core/lattice/lattice.h"

namespace ddt {

/// Of each row no more than edges near it have; Lattice::longest() is that of the longest anywhere.
/// Rows above the first are taken for the first, rows below the last for the last.
class RowReach {
public:
    /// After the lattice's last flip.
    void find(const Lattice& lattice);

    /// The last row that a vertex in row y or further up shares an edge with; never before y.
    int last_neighbour(int y) const { return at(m_last_neighbour, y); }
    /// The first row that a vertex in row y or further down shares an edge with; never after y.
    int first_neighbour(int y) const { return at(m_first_neighbour, y); }
    /// The last row in which an edge ends whose midpoint is in row y or further up.
    int last_end(int y) const { return at(m_last_end, y); }
    /// The first row in which an edge ends whose midpoint is in row y or further down.
    int first_end(int y) const { return at(m_first_end, y); }

private:
    static int at(const std::vector<int>& rows, int y);

    std::vector<int> m_last_neighbour, m_first_neighbour, m_last_end, m_first_end;
};

} // namespace ddt
