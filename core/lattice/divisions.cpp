// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/divisions.h"

#include <algorithm>
#include <cstdint>

#include "core/base/vectors/gathers.h"
#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"
#include "core/lattice/lattice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/divisions.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;

#include "core/base/vectors/lanes-inl.h"
#include "core/base/vectors/whole_vectors-inl.h"

#include "core/lattice/every_second-inl.h"
#include "core/lattice/site_lanes-inl.h"

/// The first words of cells' central edges that can be flipped, a lane each; 0 of others.
HWY_INLINE VI diagonals(const Site* sites) {
    const EverySecond edges(sites);
    return hn::IfThenZeroElse(RecordLanes{edges.first, edges.second}.rigid(), edges.first);
}

HWY_ATTR void find_divisions(const Site* centres, int n, Division* to) {
    const DI di;
    const hn::Rebind<uint8_t, DI> bytes;
    int done = each_whole_vector(n, int(hn::Lanes(di)), [&](int k) HWY_ATTR {
        const VI cells = diagonals(centres + 2 * k);
        const auto are = [&](uint32_t word)
                             HWY_ATTR { return hn::Eq(cells, hn::Set(di, int32_t(word))); };
        const auto down = hn::Or(are(down_word), are(down_word_back));
        const auto up = hn::Or(are(up_word), are(up_word_back));
        const VI which =
            hn::IfThenZeroElse(down, hn::IfThenElse(up, hn::Set(di, int(Division::up)),
                                                    hn::Set(di, int(Division::crossed))));
        hn::StoreU(hn::DemoteTo(bytes, which), bytes, reinterpret_cast<uint8_t*>(to + k));
    });
    for (; done < n; ++done)
        to[done] = division(centres[2 * done].edge);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(find_divisions);

void find_divisions(const Site* centres, int n, Division* to) {
    HWY_DYNAMIC_DISPATCH(find_divisions)(centres, n, to);
}

} // namespace ddt
#endif
