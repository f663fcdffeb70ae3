// SPDX-License-Identifier: Apache-2.0
// The gains of all edges of the mesh that a lattice starts with, without the walk from edge to
// triangle to vertex that neighbourhood() makes: row by row of cells, neighbouring cells in the
// lanes.
//
// In that mesh a cell has two triangles, and a flip makes at most two others; a triangle's gradient
// and the cost of an edge as it stands are found once instead of once for every edge near. With a
// guide in steps all differences are exact (guide.h), so it is the same from whichever vertex it is
// taken, and the gains have the bits of scalar::gain().
#include "core/triangulate/start_gains.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/base/vectors/compress_lanes.h"
#include "core/base/vectors/row_lanes.h"
#include "core/triangulate/candidates.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/triangulate/start_gains.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;
using D64 = hn::Repartition<uint64_t, D>;

#include "core/base/rsqrt-inl.h"
#include "core/base/vectors/compress-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/base/vectors/whole_vectors-inl.h"
#include "core/cost/cost-inl.h"
#include "core/triangulate/gain-inl.h"

using Floats = Lanes<D>;

#include "core/lattice/every_second-inl.h"
#include "core/triangulate/cell_rows-inl.h"
#include "core/triangulate/start_gains-inl.h"

HWY_ATTR bool inner_gains(Lattice& lattice, const Criterion& criterion, float min_gain,
                          Workspace& w, int64_t& evaluations) {
    const auto run = [&](auto which) HWY_ATTR {
        StartGains<decltype(which)> gains(lattice, criterion.contour, min_gain, w);
        const bool exact = gains.run();
        evaluations = gains.evaluations();
        return exact;
    };
    switch (criterion.cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        return run(Class<Floats>());
        DDT_COSTS(DDT_CALL)
#undef DDT_CALL
    }
    return false;
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(inner_gains);

namespace {

/// Call f(site) for the edges whose gains StartGains does not find: near the rim, where triangles
/// are missing.
template <class F>
void each_outer_edge(const Lattice& lattice, F&& f) {
    const int columns = 2 * lattice.width() - 1, rows = 2 * lattice.height() - 1;
    for (int y = 0; y < rows; ++y) {
        const int odd = y & 1, step = 2 - odd;
        const bool all = y < 2 || y >= rows - 2 || columns < 5;
        for (int x = 1 - odd; x < columns; x += step)
            if (all || x < 2 || x >= columns - 2)
                f(lattice.site(x, y));
            else
                x = columns - 2 - step; // the row's last edges come next
    }
}

} // namespace

size_t start_gains_memory(int width) {
    // Four rows of DividedCells, whose faces have three numbers, and what a Row has beyond; two of
    // candidates.
    constexpr size_t rows = 4 * (8 + 6 * 3) + 2, beyond = 4 * most_lanes;
    return rows * (size_t(width) + beyond) * sizeof(float);
}

bool start_gains(Lattice& lattice, const Criterion& criterion, float min_gain, Workspace& w,
                 Statistics& statistics) {
    w.candidates.clear();
    int64_t evaluations = 0;
    if (!lattice.fresh() ||
        !HWY_DYNAMIC_DISPATCH(inner_gains)(lattice, criterion, min_gain, w, evaluations))
        return false;
    const size_t inner = w.candidates.size();
    each_outer_edge(lattice, [&](int m) {
        if (lattice.flippable(m))
            w.candidates.push_back(m);
    });
    statistics.evaluations += evaluations + evaluate(lattice, criterion, min_gain, inner, w);
    return true;
}

} // namespace ddt
#endif
