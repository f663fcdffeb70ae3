// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/fans.h"

#include <algorithm>
#include <cstring>

#include "core/base/vectors/gathers.h"
#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/fans.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;

#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/site_lanes-inl.h"

/// Walks to the left round vertices, one a lane. A lane that came round goes on.
struct Walks {
    Ints vertex;
    VecLanes first, at;
    VI degree;
    hn::Mask<DI> open; ///< those that have not come round

    /// row: the site in column 0.
    HWY_INLINE Walks(const SiteLanes& lattice, int row, const int* columns)
        : vertex{hn::Add(hn::Set(DI(), row), hn::ShiftLeft<1>(hn::LoadU(DI(), columns)))},
          first(lattice.first(vertex)), at(first), degree(hn::Zero(DI())),
          open(hn::FirstN(DI(), hn::Lanes(DI()))) {}

    /// To the next spoke. Twin of next_spoke().
    HWY_INLINE void step(const SiteLanes& lattice) {
        const EdgeLanes e = lattice.edge(vertex + lattice.offset(at));
        const VecLanes apex{hn::IfThenElse(hn::Eq(e.v.xy, at.xy), e.left.xy, e.right.xy)};
        at = half(at + apex);
        degree = hn::IfThenElse(open, hn::Add(degree, hn::Set(DI(), 1)), degree);
        open = hn::AndNot(hn::Eq(at.xy, first.xy), open);
    }
    HWY_INLINE bool any_open() const { return !hn::AllFalse(DI(), open); }

    HWY_INLINE void store_spokes(Vec* to) const {
        static_assert(sizeof(Vec) == 2 && offsetof(Vec, x) == 0, "x in the low byte");
        const hn::Rebind<uint16_t, DI> d16;
        hn::StoreU(hn::DemoteTo(d16, at.bytes()), d16, reinterpret_cast<uint16_t*>(to));
    }
};

/// Vertices that are walked round at once: of two vectors, so that while one waits for its loads
/// there is something to be done for the other.
HWY_INLINE int walked_at_once() {
    return 2 * int(hn::Lanes(DI()));
}
constexpr int most_at_once = 2 * most_lanes;

/// Walk round walked_at_once() vertices of a row: spoke k of vertex i to walked[k *
/// walked_at_once() + i].
HWY_INLINE void walk_round(const SiteLanes& lattice, int row, const int* columns,
                           std::vector<Vec>& walked, int* degrees) {
    const size_t lanes = hn::Lanes(DI());
    Walks a(lattice, row, columns), b(lattice, row, columns + lanes);
    for (size_t place = 0;; place += 2 * lanes) {
        if (walked.size() < place + 2 * lanes)
            walked.resize(2 * (place + 2 * lanes));
        a.store_spokes(walked.data() + place);
        b.store_spokes(walked.data() + place + lanes);
        if (!a.any_open() && !b.any_open())
            break;
        a.step(lattice);
        b.step(lattice);
    }
    hn::StoreU(a.degree, DI(), degrees);
    hn::StoreU(b.degree, DI(), degrees + lanes);
}

/// Add the group of walks from vertex i on.
HWY_INLINE void add_group(const int* columns, const int* degrees, int i,
                          const std::vector<Vec>& walked, Fans& fans) {
    Fans::Group& group = fans.groups.emplace_back();
    const auto [least, most] = std::minmax_element(degrees + i, degrees + i + fans_side_by_side);
    group.least = uint16_t(*least);
    group.most = uint16_t(*most);
    for (int k = 0; k < fans_side_by_side; ++k) {
        group.x[k] = columns[i + k];
        group.degree[k] = uint16_t(degrees[i + k]);
    }
    group.first = uint32_t(fans.spokes.size());
    const size_t spokes = size_t(group.most + 1) * fans_side_by_side;
    fans.spokes.resize(group.first + spokes);
    Vec* to = fans.spokes.data() + group.first;
    const Vec* from = walked.data() + i;
    for (Vec* const end = to + spokes; to < end; to += fans_side_by_side, from += walked_at_once())
        std::memcpy(to, from, fans_side_by_side * sizeof(Vec));
}

HWY_ATTR void find_fans(const Lattice& lattice, int y, const int* columns, int n,
                        std::vector<Vec>& walked, Fans& fans) {
    fans.groups.clear();
    fans.spokes.clear();
    // Vectors that grow by themselves would take up to twice of it.
    fans.groups.reserve(size_t(n + fans_side_by_side - 1) / fans_side_by_side);
    fans.spokes.reserve(size_t(n) * usual_spokes + Fans::padding);
    const SiteLanes lanes(lattice);
    const int at_once = walked_at_once();
    for (int done = 0; done < n; done += at_once) {
        const int left = std::min(at_once, n - done);
        int filled_up[most_at_once], degrees[most_at_once];
        const int* x = columns + done;
        if (left < at_once) {
            std::fill(std::copy_n(x, left, filled_up), filled_up + at_once, columns[n - 1]);
            x = filled_up;
        }
        walk_round(lanes, lattice.vertex_site(0, y), x, walked, degrees);
        for (int i = 0; i < left; i += fans_side_by_side)
            add_group(x, degrees, i, walked, fans);
    }
    fans.spokes.resize(fans.spokes.size() + Fans::padding);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(find_fans);

void find_fans(const Lattice& lattice, int y, const int* columns, int n, std::vector<Vec>& walked,
               Fans& fans) {
    HWY_DYNAMIC_DISPATCH(find_fans)(lattice, y, columns, n, walked, fans);
}

} // namespace ddt
#endif
