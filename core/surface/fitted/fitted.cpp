// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fitted/fitted.h"

#include <algorithm>
#include <cstddef>

#include "core/base/arith.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/fitted/fitted.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

#include "core/base/rsqrt-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/surface/consistency/consistency-inl.h"
#include "core/surface/fitted/features-inl.h"

#include "core/base/vectors/row_lanes-inl.h"

/// Where vertices go, and their index.
template <class T, class Tap>
HWY_INLINE T move_vertex(const Correction& correction, bool cut, T sum, Tap tap, T& index) {
    const FittedTable& table = fitted_table();
    VertexFeatures<T> v;
    v.find(T(0.0f) - sum * T(0.25f), cut, table, tap);
    index = v.index;
    T low, high;
    find_limits({-1, -1, 2, 2}, fitted_limit(T(correction.limit), v.bound, table),
                correction.clipped, tap, low, high);
    return fitted_vertex(tap(0, 0), T(correction.strength), low, high, v, table);
}

HWY_ATTR void move_fitted(const FittedSource& source, int x0, int x1, int y,
                          const Correction& correction, const float* sum, float* index,
                          ControlNet& net) {
    const Lattice& lattice = source.lattice;
    const int width = lattice.width(), height = lattice.height(), count = source.count;
    const ptrdiff_t row = ptrdiff_t(width) * count;
    float* const z = net.vertex(lattice.vertex_site(0, y));
    const float* const here = source.at(0, y);
    // Where there is all_pixels().
    const bool inner = y >= vertex_taps && y + vertex_taps < height;
    const int begin = inner ? std::max(x0, vertex_taps) : x1,
              end = std::max(std::min(x1, width - vertex_taps), begin);
    each_vector(begin, end, count, [&](auto vector, const RowPlace& place) HWY_ATTR {
        using T = decltype(vector);
        const auto tap = [&](int i, int j)
                             HWY_ATTR { return T::load(here + place.at + j * row + i * count); };
        T at;
        move_vertex(correction, correction.clipped, T::load(sum + place.at), tap, at)
            .store(z + place.at);
        at.store(index + place.at);
    });
    const auto inside = [&](int i, int j) HWY_ATTR { return PixelLanes::load(source.at(i, j)); };
    const auto one = [&](int x) HWY_ATTR {
        const auto tap = [&](int i, int j) HWY_ATTR {
            return odd_mirror_tap<PixelLanes>(x + i, y + j, width, height, inside);
        };
        const ptrdiff_t at = ptrdiff_t(x) * count;
        PixelLanes found;
        // Not all_pixels().
        const bool cut = false;
        const PixelLanes moved =
            move_vertex(correction, cut, PixelLanes::load(sum + at), tap, found);
        if (x > 0 && y > 0 && x + 1 < width && y + 1 < height)
            store_pixel(moved, count, z + at);
        store_pixel(found, count, index + at);
    };
    for (int x = x0; x < x1; ++x)
        if (x < begin || x >= end)
            one(x);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(move_fitted);

void move_fitted(const FittedSource& source, int x0, int x1, int y, const Correction& correction,
                 const float* sum, float* index, ControlNet& net) {
    HWY_DYNAMIC_DISPATCH(move_fitted)(source, x0, x1, y, correction, sum, index, net);
}

} // namespace ddt
#endif
