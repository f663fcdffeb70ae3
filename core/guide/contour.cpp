// SPDX-License-Identifier: Apache-2.0
#include "core/guide/contour.h"

#include <algorithm>

#include "core/base/arith.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/guide/contour.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {

using scalar::rsqrt_seed;
#include "core/base/rsqrt-inl.h"
#include "core/guide/contour-inl.h"

/// Tensors of the n cells between two rows of pixels, a plane after the other.
HWY_ATTR void cell_tensors(const float* above, const float* below, size_t n, float* xx, float* yy,
                           float* xy) {
    for (size_t x = 0; x < n; ++x) {
        const Tensor t = cell_tensor(above[x], above[x + 1], below[x], below[x + 1]);
        xx[x] = t.xx;
        yy[x] = t.yy;
        xy[x] = t.xy;
    }
}

/// n numbers smoothed with the three before and after each.
HWY_ATTR void smooth_along(const float* in, size_t n, float* out) {
    for (size_t x = 0; x < n; ++x)
        out[x] = smooth(in[x], in[x + 1], in[x + 2], in[x + 3], in[x + 4], in[x + 5], in[x + 6]);
}

/// Words of a row of n cells from seven rows of three planes of n numbers each.
HWY_ATTR void contour_words(const float* const* rows, size_t n, uint32_t* words) {
    const float *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3], *e = rows[4], *f = rows[5],
                *g = rows[6];
    for (size_t x = 0; x < n; ++x) {
        const auto mean = [=](size_t i)
                              HWY_ATTR { return smooth(a[i], b[i], c[i], d[i], e[i], f[i], g[i]); };
        words[x] = contour_word({mean(x), mean(x + n), mean(x + 2 * n)});
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(cell_tensors);
HWY_EXPORT(smooth_along);
HWY_EXPORT(contour_words);

ContourRows::ContourRows(const float* guide, int width, int height)
    : m_guide(guide), m_cells(size_t(width - 1)), m_rows(height - 1),
      m_products(3 * (m_cells + 2 * reach)), m_smoothed(3 * ring * m_cells), m_words(m_cells) {}

void ContourRows::smooth_row(int y) {
    const float* above = m_guide + size_t(y) * (m_cells + 1);
    const size_t padded = m_cells + 2 * reach;
    float* const first = m_products.data();
    HWY_DYNAMIC_DISPATCH(cell_tensors)
    (above, above + m_cells + 1, m_cells, first + reach, first + padded + reach,
     first + 2 * padded + reach);
    for (size_t k = 0; k < 3; ++k) {
        float* plane = first + k * padded;
        std::fill_n(plane, reach, plane[reach]);
        std::fill_n(plane + reach + m_cells, reach, plane[reach + m_cells - 1]);
        HWY_DYNAMIC_DISPATCH(smooth_along)(plane, m_cells, smoothed(y) + k * m_cells);
    }
}

const uint32_t* ContourRows::next() {
    const int y = m_next++;
    for (; m_made < std::min(y + reach + 1, m_rows); ++m_made)
        smooth_row(m_made);
    const float* rows[2 * reach + 1];
    for (int k = -reach; k <= reach; ++k)
        rows[k + reach] = smoothed(std::clamp(y + k, 0, m_rows - 1));
    HWY_DYNAMIC_DISPATCH(contour_words)(rows, m_cells, m_words.data());
    return m_words.data();
}

} // namespace ddt
#endif
