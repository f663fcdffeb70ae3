// SPDX-License-Identifier: Apache-2.0
// Where the guide's contours run: a structure tensor for each cell (2x2 pixels).
//
// The cost of an edge sees two triangles and the noise in them; the tensor is the mean over seven
// by seven cells. (Förstner & Gülch 1987, "A fast operator for detection and precise location of
// distinct points, corners and centres of circular features"; Bigün & Granlund 1987.) With
//
//   T = mean of (gx gx, gy gy, gx gy),  N = T / (Txx + Tyy + n^2),  n = 0.05 a pixel,
//
// v' N v is about the square of the distance that v goes across the contour, and little where
// nothing but noise is.
//
// Where contours of many directions meet, as in a screentone of single dots, what is left of a
// direction is chance: the half (Nxx - Nyy) / 2, Nxy that turns with it (its length is half of the
// tensor's coherence) is multiplied by the fourth power of its length / 0.09 where it is shorter
// than that, and v' N v is the more the same all around.
//
// To Nxx and Nyy 0.01 is added: without contours short edges are the better ones.
//
// A cell's N is one word, three integers of contour_bits bits: Nxx, Nyy in steps of
// 1 / contour_steps, then Nxy with half of the steps added, so that it is not negative. The sum of
// two cells' words has the sums of their integers. All that follows from it is exact.
// The numbers are in core/base/constants.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/constants.h"

namespace ddt {

constexpr int contour_mask = (1 << contour_bits) - 1;

/// Nxy of a cell's word, in steps.
inline int contour_xy(uint32_t word) {
    return int(word >> (2 * contour_bits)) - contour_steps / 2;
}

/// Words of the cells of a guide, row by row from the top; keeps a few rows only.
class ContourRows {
public:
    /// `guide`: width x height floats, both at least 2, that stay where they are.
    ContourRows(const float* guide, int width, int height);
    /// Bytes that this takes, about.
    static size_t memory(int width) { return (3 * (ring + 1) + 1) * sizeof(float) * size_t(width); }
    /// The width - 1 words of the next row of cells; for height - 1 rows.
    const uint32_t* next();

private:
    static constexpr int reach = 3, ring = 8;
    float* smoothed(int y) { return m_smoothed.data() + size_t(y % ring) * 3 * m_cells; }
    void smooth_row(int y);

    const float* m_guide;
    size_t m_cells; ///< in a row
    int m_rows;     ///< of cells
    int m_next = 0; ///< of them
    int m_made = 0; ///< those smoothed along x
    std::vector<float> m_products, m_smoothed;
    std::vector<uint32_t> m_words;
};

} // namespace ddt
