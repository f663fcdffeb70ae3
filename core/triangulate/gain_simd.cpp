// SPDX-License-Identifier: Apache-2.0
// SIMD twin of scalar::gain(): several edges at once, compiled for each instruction set.
#include "core/base/compress_lanes.h"
#include "core/triangulate/gain.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/triangulate/gain_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;

#include "core/base/compress-inl.h"
#include "core/base/lanes-inl.h"
#include "core/base/rsqrt-inl.h"
#include "core/cost/cost-inl.h"

#include "core/lattice/site_lanes-inl.h"

#include "core/lattice/known_lanes-inl.h"
#include "core/triangulate/gain-inl.h"

/// Gains of the flippable edges at m, one a lane; `contour` times contour_unit of the contours', if
/// any.
template <class Cost_, class Mesh>
HWY_INLINE hn::Vec<D> gains_of(const Mesh& mesh, float contour, Ints m) {
    if (contour == 0)
        return flip_gain<Cost_>(neighbourhood<Floats>(mesh, m)).v;
    return gain_with_contours<Cost_, Floats>(mesh, m, contour).v;
}

/// Store the gains of flippable edges at their sites; call each(sites, gains, n) for every vector,
/// of which n lanes count. mesh_at(i, n): a lattice as neighbourhood() sees it for those lanes.
template <class Cost_, class MeshAt, class Each>
HWY_INLINE void each_block(float contour, const int* sites, size_t count, MeshAt&& mesh_at,
                           float* out, Each&& each) {
    const D d;
    const size_t lanes = hn::Lanes(d);
    HWY_ALIGN float gain[HWY_MAX_BYTES / sizeof(float)];
    for (size_t i = 0; i < count; i += lanes) {
        const size_t used = count - i < lanes ? count - i : lanes;
        const Ints m = load_sites(sites + i, used);
        const auto g = gains_of<Cost_>(mesh_at(i, used), contour, m);
        hn::Store(g, d, gain);
        for (size_t k = 0; k < used; ++k)
            out[sites[i + k]] = gain[k];
        each(m, g, used);
    }
}

/// The same of the criterion's cost.
template <class MeshAt, class Each>
HWY_INLINE void each_gain(const Criterion& criterion, const int* sites, size_t count,
                          MeshAt&& mesh_at, float* out, Each&& each) {
    const float contour = criterion.contour * contour_unit;
    switch (criterion.cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        return each_block<Class<Floats>>(contour, sites, count, mesh_at, out, each);
        DDT_COSTS(DDT_CALL)
#undef DDT_CALL
    }
}

HWY_ATTR void gains(const Lattice& lattice, const Criterion& criterion, const int* sites,
                    size_t count, float* out) {
    const SiteLanes mesh(lattice);
    each_gain(
        criterion, sites, count, [&](size_t, size_t) HWY_ATTR { return mesh; }, out,
        [](Ints, hn::Vec<D>, size_t) HWY_ATTR {});
}

/// Some edges, divided into those that can be flipped and others, each in their order.
class DividedEdges {
public:
    /// What is known of as many leaves room in the nearest cache.
    static constexpr size_t most = 256;

    HWY_INLINE DividedEdges(const SiteLanes& mesh, const int* sites, size_t count) : m_mesh(mesh) {
        divide(sites, count);
        m_known.find_sides(mesh, m_flippable, m_flippable_count);
    }
    const int* flippable() const { return m_flippable; }
    size_t flippable_count() const { return m_flippable_count; }
    /// As seen from n flippable edges, those from number i on.
    HWY_INLINE KnownLanes mesh_at(size_t i, size_t n) const {
        return m_known.mesh_at(m_mesh, i, n);
    }
    /// Store the gain of the others at their sites.
    HWY_INLINE void store_no_gain(float* out) const {
        for (size_t k = 0; k < m_other_count; ++k)
            out[m_others[k]] = no_gain;
    }

private:
    /// Twin of Edge::flippable().
    HWY_INLINE void divide(const int* sites, size_t count) {
        const DI di;
        static_assert((longest_edge & (longest_edge + 1)) == 0, "longer ones have other bits");
        const VI none = hn::Zero(di),
                 beyond_longest = hn::Set(di, ~(longest_edge << 16 | longest_edge));
        const size_t lanes = hn::Lanes(di);
        for (size_t i = 0; i < count; i += lanes) {
            const size_t used = count - i < lanes ? count - i : lanes;
            const Ints m = load_sites(sites + i, used);
            const RecordLanes record = m_mesh.record(m);
            const EdgeLanes e = EdgeLanes::of(record.first, record.second);
            const VI far = hn::And(hn::BitCast(di, hn::Abs(e.left.halves())), beyond_longest);
            const auto can =
                hn::AndNot(e.left.zero(), hn::Eq(hn::Or((e.left + e.right).xy, far), none));
            const auto here = hn::FirstN(di, used), good = hn::And(can, here);
            store_compressed(record.first, good, m_known.own + m_flippable_count);
            m_flippable_count += store_compressed(m.i, good, m_flippable + m_flippable_count);
            m_other_count += store_compressed(m.i, hn::AndNot(can, here), m_others + m_other_count);
        }
    }
    const SiteLanes& m_mesh;
    size_t m_flippable_count = 0, m_other_count = 0;
    using Known = KnownEdges<most>;
    Known m_known; ///< of the flippable
    int m_flippable[Known::room], m_others[Known::room];
};

HWY_ATTR void find_candidates(const Lattice& lattice, const Criterion& criterion, float min_gain,
                              const int* sites, size_t count, float* out, int* candidates,
                              Evaluated& found) {
    const SiteLanes mesh(lattice);
    const auto least = hn::Set(D(), min_gain);
    for (size_t i = 0; i < count; i += DividedEdges::most) {
        const DividedEdges edges(mesh, sites + i, std::min(count - i, DividedEdges::most));
        edges.store_no_gain(out);
        found.flippable += edges.flippable_count();
        each_gain(
            criterion, edges.flippable(), edges.flippable_count(),
            [&](size_t first, size_t n) HWY_ATTR { return edges.mesh_at(first, n); }, out,
            [&](Ints m, hn::Vec<D> g, size_t used) HWY_ATTR {
                const DI di;
                const auto good = hn::RebindMask(di, hn::Gt(g, least));
                found.candidates += store_compressed(m.i, hn::And(good, hn::FirstN(di, used)),
                                                     candidates + found.candidates);
            });
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(gains);
HWY_EXPORT(find_candidates);

void gains(const Lattice& lattice, const Criterion& criterion, const int* sites, size_t n,
           float* out) {
    if (lattice.width() > widest_lanes)
        return dispatch(criterion.cost, [&](auto cost) {
            for (size_t i = 0; i < n; ++i)
                out[sites[i]] = gain_of<decltype(cost)>(lattice, sites[i], criterion.contour);
        });
    HWY_DYNAMIC_DISPATCH(gains)(lattice, criterion, sites, n, out);
}

Evaluated find_candidates(const Lattice& lattice, const Criterion& criterion, float min_gain,
                          const int* sites, size_t n, std::vector<float>& gain, int* candidates) {
    if (lattice.width() > widest_lanes)
        return find_candidates<Lattice>(lattice, criterion, min_gain, sites, n, gain, candidates);
    Evaluated found;
    HWY_DYNAMIC_DISPATCH(find_candidates)
    (lattice, criterion, min_gain, sites, n, gain.data(), candidates, found);
    return found;
}

} // namespace ddt
#endif
