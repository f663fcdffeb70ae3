// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/start_rows.h"

#include <algorithm>

#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/start_rows.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;
using D64 = hn::Repartition<uint64_t, D>;

#include "core/base/vectors/whole_vectors-inl.h"

HWY_ATTR int divide_flat(const float* upper, const float* lower, const uint32_t* words, int n,
                         DownFlag* down) {
    const D d;
    const DI di;
    return each_whole_vector(n, int(hn::Lanes(d)), [&](int x) HWY_ATTR {
        const auto falling = hn::Sub(hn::LoadU(d, upper + x), hn::LoadU(d, lower + x + 1)),
                   rising = hn::Sub(hn::LoadU(d, upper + x + 1), hn::LoadU(d, lower + x));
        auto go_down = hn::RebindMask(di, hn::Le(hn::Abs(falling), hn::Abs(rising)));
        if (words) {
            // Twin of contour_xy().
            const auto word = hn::LoadU(di, reinterpret_cast<const int32_t*>(words) + x);
            const auto xy = hn::ShiftRight<2 * contour_bits>(word),
                       none = hn::Set(di, contour_steps / 2);
            go_down = hn::Or(hn::Lt(xy, none), hn::And(hn::Eq(xy, none), go_down));
        }
        hn::StoreU(hn::IfThenElseZero(go_down, hn::Set(di, diagonal_down)), di, down + x);
    });
}

/// Records of edges between these cells, a lane each.
HWY_INLINE hn::Vec<D64> records(const RecordOfTwo& of, const DownFlag* first,
                                const DownFlag* second) {
    const D64 d64;
    const hn::RebindToSigned<D64> signed64;
    const hn::Rebind<int32_t, D64> d32;
    const auto masks = [&](const DownFlag* flags) HWY_ATTR {
        return hn::BitCast(d64, hn::PromoteTo(signed64, hn::LoadU(d32, flags)));
    };
    const auto a = masks(first), b = masks(second);
    const auto changes =
        hn::Xor(hn::And(a, hn::Set(d64, of.first_down)), hn::And(b, hn::Set(d64, of.second_down)));
    return hn::Xor(hn::Xor(hn::Set(d64, of.both_up), changes),
                   hn::And(hn::And(a, b), hn::Set(d64, of.both_down)));
}

HWY_ATTR int make_even_row(const float* guide, const uint32_t* words, const DownFlag* above,
                           const DownFlag* below, const RecordOfTwo& horizontals, int n, Site* to) {
    static_assert(offsetof(Vertex, guide) == 0 && offsetof(Vertex, contour) == 4, "two halves");
    const D64 d64;
    const hn::Rebind<uint32_t, D64> d32;
    const auto load = [&](const void* p) HWY_ATTR {
        return hn::PromoteTo(d64, hn::LoadU(d32, static_cast<const uint32_t*>(p)));
    };
    return each_whole_vector(n, int(hn::Lanes(d64)), [&](int x) HWY_ATTR {
        auto vertices = load(guide + x);
        if (words)
            vertices = hn::Or(vertices, hn::ShiftLeft<32>(load(words + x)));
        hn::StoreInterleaved2(vertices, records(horizontals, above + x, below + x), d64,
                              reinterpret_cast<uint64_t*>(to + 2 * x));
    });
}

HWY_ATTR int make_odd_row(const DownFlag* cells, const RecordOfTwo& verticals,
                          const RecordOfTwo& diagonals, int n, Site* to) {
    const D64 d64;
    return each_whole_vector(n, int(hn::Lanes(d64)), [&](int x) HWY_ATTR {
        hn::StoreInterleaved2(records(verticals, cells + x - 1, cells + x),
                              records(diagonals, cells + x, cells + x), d64,
                              reinterpret_cast<uint64_t*>(to + 2 * x));
    });
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(divide_flat);
HWY_EXPORT(make_even_row);
HWY_EXPORT(make_odd_row);

int divide_flat(const float* upper, const float* lower, const uint32_t* words, int n,
                DownFlag* down) {
    return HWY_DYNAMIC_DISPATCH(divide_flat)(upper, lower, words, n, down);
}

int make_even_row(const float* guide, const uint32_t* words, const DownFlag* above,
                  const DownFlag* below, const RecordOfTwo& horizontals, int n, Site* to) {
    return HWY_DYNAMIC_DISPATCH(make_even_row)(guide, words, above, below, horizontals, n, to);
}

int make_odd_row(const DownFlag* cells, const RecordOfTwo& verticals, const RecordOfTwo& diagonals,
                 int n, Site* to) {
    return HWY_DYNAMIC_DISPATCH(make_odd_row)(cells, verticals, diagonals, n, to);
}

} // namespace ddt
#endif
