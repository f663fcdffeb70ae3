// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: flippable edges and the sides of their quads. A gather
// that waits for another, which told it where, waits twice as long in a lattice that is in no near
// cache. So of many edges the own records are gathered first, then those of the sides, and what
// follows waits for neither.
// Needs: site_lanes-inl.h.

/// A lattice seen from flippable edges whose records are at hand, and those of their quads' sides.
struct KnownLanes : SiteLanes {
    VI own; ///< SiteLanes::first_word()
    RecordLanes sides[4];

    explicit HWY_INLINE KnownLanes(const SiteLanes& mesh) : SiteLanes(mesh) {}
    HWY_INLINE FlippableLanes flippable_edge(Ints) const { return FlippableLanes::of(own); }
    HWY_INLINE RecordLanes side(int k, Ints) const { return sides[k]; }
};

/// The records of up to `most` flippable edges sites[0..n) and of their quads' sides.
template <size_t most>
struct KnownEdges {
    static constexpr size_t room =
        most + HWY_MAX_BYTES / sizeof(int); ///< whole vectors are written
    int own[room];                          ///< SiteLanes::first_word()
    uint64_t sides[4][room];                ///< records, as SiteLanes::copy_records() has them

    HWY_INLINE KnownEdges(const SiteLanes& mesh, const int* sites, size_t n) {
        const DI di;
        const size_t lanes = hn::Lanes(di);
        for (size_t i = 0; i < n; i += lanes)
            hn::StoreU(mesh.first_word(load_sites(sites + i, n - i)), di, own + i);
        int middle[4][room];
        for (size_t i = 0; i < n; i += lanes) {
            const Ints m = load_sites(sites + i, n - i);
            const FlippableLanes e = FlippableLanes::of(hn::LoadU(di, own + i));
            const QuadOf<VecLanes> q(e.v, e.left);
            const QuadSites<Ints> at(m, mesh.offset(q.w), mesh.offset(q.side[1]));
            for (int k = 0; k < 4; ++k)
                hn::StoreU(at.middle[k].i, di, middle[k] + i);
        }
        const size_t whole = (n + lanes - 1) / lanes * lanes; // as load_sites() fills up
        for (int k = 0; k < 4; ++k)
            mesh.copy_records(middle[k], whole, sides[k]);
    }
    /// The mesh as seen from the edges from i on, by as many as a vector has: where there are
    /// fewer, as load_sites() fills up.
    HWY_INLINE KnownLanes mesh_at(const SiteLanes& mesh, size_t i) const {
        const DI di;
        KnownLanes known(mesh);
        known.own = hn::LoadU(di, own + i);
        for (int k = 0; k < 4; ++k)
            known.sides[k] = RecordLanes::of(load_copied(sides[k] + i));
        return known;
    }
};
