// SPDX-License-Identifier: Apache-2.0
// The crossed cells of a row (Division::crossed), which are few: looking at each cell would take
// longer than what is then done with those.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "core/base/arith.h"
#include "core/lattice/lattice.h"

namespace ddt {

/// A byte for each of cells_at_once cells of a row, the first cell's lowest: not 0 where it is
/// crossed.
inline uint64_t crossed_cells(const Division* divisions) {
    uint64_t word;
    std::memcpy(&word, divisions, sizeof word);
    return word & 0x0202020202020202u;
}

/// The divisions of the cells above and below a row of pixels; those of the nearest row of cells
/// where there is none.
struct NearDivisions {
    const Division *above, *below;
    NearDivisions(const Lattice& lattice, int y)
        : above(lattice.divisions(std::max(y - 1, 0))),
          below(lattice.divisions(std::min(y, lattice.height() - 2))) {}
    /// crossed_cells() round pixels x, x + 1, ...: those on both sides of each, in both rows.
    uint64_t crossed_beside(int x) const {
        return crossed_cells(above + x - 1) | crossed_cells(above + x) |
               crossed_cells(below + x - 1) | crossed_cells(below + x);
    }
};

/// The first column from x on that is outside begin .. end - 1, or has a byte that is not 0.
/// crossed(x): bytes of columns x .. x + 7; those at or after `end` may be anything.
template <class Crossed>
DDT_INLINE int next_crossed(int x, int begin, int end, Crossed&& crossed) {
    if (x < begin || x >= end)
        return x;
    for (; x < end; x += cells_at_once)
        if (const uint64_t word = crossed(x))
            return std::min(x + __builtin_ctzll(word) / 8, end);
    return end;
}

/// Which of cells_at_once bytes are not 0, one after the other, by a bit each.
struct ListedBytes {
    uint8_t of[1 << cells_at_once][cells_at_once] = {};
    constexpr ListedBytes() {
        for (int bits = 0; bits < 1 << cells_at_once; ++bits)
            for (int i = 0, n = 0; i < cells_at_once; ++i)
                if (bits >> i & 1)
                    of[bits][n++] = uint8_t(i);
    }
};
inline constexpr ListedBytes listed_bytes;

/// List the columns from x0 to x1 - 1 that have a byte which is not 0, of crossed_cells(). Returns
/// how many; as many as cells_at_once more may be written. For where they are many.
template <class Crossed>
DDT_INLINE int list_crossed(int x0, int x1, Crossed&& crossed, int* columns) {
    int n = 0;
    for (int x = x0; x < x1; x += cells_at_once) {
        const uint64_t word = crossed(x) >> 1;
        if (!word)
            continue;
        // Branch-free: a branch on each byte would be mispredicted. The top byte of a product is a
        // sum of bytes: of bit k of byte k, or of how many there are.
        uint8_t listed[cells_at_once]; // a copy, which no column is in the way of
        std::memcpy(listed, listed_bytes.of[word * 0x0102040810204080u >> 56], sizeof listed);
        for (int i = 0; i < cells_at_once; ++i)
            columns[n + i] = x + listed[i];
        n += int(word * 0x0101010101010101u >> 56);
    }
    while (n > 0 && columns[n - 1] >= x1)
        --n;
    return n;
}

} // namespace ddt
