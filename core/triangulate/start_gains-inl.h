// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: the gains of the edges of a starting mesh that are not
// near its rim.
// Needs: <algorithm>, arena.h, contour.h, triangulate.h, compress-inl.h,
// whole_vectors-inl.h, gain-inl.h, every_second-inl.h, cell_rows-inl.h, tags D of float, DI of
// int32_t and D64 of uint64_t.

/// Goes down the rows of cells of a lattice.
template <class Cost>
class StartGains {
public:
    using Face = typename Cost::Face;
    using Cells = DividedCells<Face>;
    using Edges = Flip<Cost, Floats, Always>;

    HWY_ATTR StartGains(Lattice& lattice, float contour, float min_gain, Workspace& w)
        : m_lattice(lattice), m_contour(contour * contour_unit), m_min_gain(min_gain), m_w(w) {
        for (Cells& row : m_rows)
            row.resize(lattice.width());
        m_found.resize(2 * size_t(lattice.width()) + 2 * most_lanes);
    }

    /// False if the guide is not in steps: then nothing is worth anything.
    HWY_ATTR bool run() {
        const int rows = m_lattice.height() - 1;
        if (!load_vertices(0))
            return false;
        for (int y = 0; y < rows; ++y) {
            if (!load_vertices(y + 1))
                return false;
            make_faces(y);
            if (y > 1)
                odd_row(y - 1);
            if (y > 0)
                horizontal(y);
        }
        return true;
    }

    int64_t evaluations() const { return m_evaluations; }

private:
    static constexpr int ring = 4;
    Cells& row(int y) { return m_rows[y % ring]; }

    /// Call f(x, records) for vectors of n records, those of every second site, that begin at x and
    /// cover 0 .. n - 1. Where n are not a vector, what lies past them is 0; else the last repeats
    /// some of the one before.
    template <class F>
    static HWY_INLINE void each_record(const Site* sites, int n, F&& f) {
        const int lanes = int(hn::Lanes(DI()));
        if (n < lanes) {
            Site few[2 * most_lanes];
            std::copy_n(sites, 2 * n - 1, few);
            f(0, EverySecond(few));
            return;
        }
        each_whole_vector(n, lanes, [&](int x) HWY_ATTR { f(x, EverySecond(sites + 2 * x)); });
    }

    /// Row y of vertices and what they know of the cells below. False if the guide is not in steps.
    HWY_ATTR bool load_vertices(int y) {
        Cells& cells = row(y);
        bool exact = true;
        each_record(m_lattice.sites() + m_lattice.vertex_site(0, y), m_lattice.width(),
                    [&](int x, const EverySecond& vertices) HWY_ATTR {
                        const Floats guide = hn::BitCast(D(), vertices.first);
                        exact &= in_steps(guide);
                        cells.guide.store(x, guide);
                        if (m_contour != 0)
                            store_contours(x, vertices.second, cells);
                    });
        return exact;
    }

    /// Twin of contour_xy() and its like.
    static HWY_INLINE void store_contours(int x, hn::Vec<DI> words, Cells& cells) {
        const D d;
        const DI di;
        const auto mask = hn::Set(di, contour_mask);
        const auto yy = hn::And(hn::ShiftRight<contour_bits>(words), mask);
        const auto xy =
            hn::Sub(hn::ShiftRight<2 * contour_bits>(words), hn::Set(di, contour_steps / 2));
        cells.xx.store(x, hn::ConvertTo(d, hn::And(words, mask)));
        cells.yy.store(x, hn::ConvertTo(d, yy));
        cells.xy.store(x, hn::ConvertTo(d, xy));
    }

    /// How row y of cells is divided: where the central edge's v.x, its first byte, is positive.
    HWY_ATTR void load_divisions(int y, Row& down) {
        const DI di;
        each_record(m_lattice.sites() + m_lattice.site(1, 2 * y + 1), m_lattice.width() - 1,
                    [&](int x, const EverySecond& edges) HWY_ATTR {
                        const auto right = hn::Gt(hn::ShiftLeft<24>(edges.first), hn::Zero(di));
                        down.store(
                            x, hn::IfThenElseZero(hn::RebindMask(D(), right), hn::Set(D(), 1.0f)));
                    });
    }

    /// The gain of a flip. along: what it lowers v' N v by, as contour_gain() says, asked for where
    /// that counts.
    template <class Along>
    HWY_INLINE Floats gain(const Edges& f, Along&& along) const {
        const Floats by_cost = f.gain();
        return m_contour == 0 ? by_cost : by_cost + Floats(m_contour) * along();
    }

    /// Whether all lanes are multiples of guide_unit within -guide_limit to guide_limit.
    static HWY_INLINE bool in_steps(Floats z) {
        const D d;
        const auto scaled = hn::Mul(z.v, hn::Set(d, 1.0f / guide_unit));
        const auto whole = hn::Eq(hn::Round(scaled), scaled);
        const auto small = hn::Le(hn::Abs(z.v), hn::Set(d, guide_limit));
        return hn::AllTrue(d, hn::And(whole, small));
    }

    /// The triangles of row y of cells; costs of its diagonals and of the edges on its top. From so
    /// far before the row that all vectors are aligned: what is there is 0.
    HWY_ATTR void make_faces(int y) {
        Cells& cells = row(y);
        const Cells& upper = row(y + ring - 1);
        const Row &above = cells.guide, &below = row(y + 1).guide;
        const int count = m_lattice.width() - 1, lanes = int(hn::Lanes(D()));
        const Floats one(1.0f), zero(0.0f);
        load_divisions(y, cells.down);
        for (int x = 1 - lanes; x < count; x += lanes) {
            const Floats z0 = above.load(x), z1 = above.load(x + 1), z2 = below.load(x),
                         z3 = below.load(x + 1);
            const Floats top = z1 - z0, bottom = z3 - z2, left = z2 - z0, right = z3 - z1;
            const Face ul = Cost::face(top, left), ur = Cost::face(top, right),
                       ll = Cost::face(bottom, left), lr = Cost::face(bottom, right);
            const Floats down = cells.down.load(x);
            const Face t = either(down, ur, ul), b = either(down, ll, lr);
            cells.top.store(x, t);
            cells.bottom.store(x, b);
            cells.left.store(x, either(down, ll, ul));
            cells.right.store(x, either(down, ur, lr));
            cells.other_top.store(x, either(down, ul, ur));
            cells.other_bottom.store(x, either(down, lr, ll));
            cells.diagonal_cost.store(x, Cost::between(t, b, one, one));
            cells.top_cost.store(x, Cost::between(upper.bottom.load(x), t, one, zero));
        }
        for (int x = 1; x < count; x += lanes)
            cells.left_cost.store(
                x, Cost::between(cells.right.load(x - 1), cells.left.load(x), zero, one));
    }

    /// Gains of the edges on top of row y of cells. Such an edge ab can be flipped where the cells
    /// on both its sides are divided alike:
    ///
    ///       both down                          both up
    ///     +---- d ----1----+                +---- 0 ---- d ----+
    ///     |     | \ T |    |   row y - 1    |     | T /  |     |
    ///     |  R  |   \ |    |                |     |  /   |  L  |
    ///     +---- a --- b ---+                +---- a ---- b ----+
    ///     |     | \   |  L |   row y        |  R  |   /  |     |
    ///     |     | B \ |    |                |     |  / B |     |
    ///     +---- 2 --- c ---+                +---- c ---- 3 ----+
    ///
    /// T and B are the cells' triangles beyond the diagonals, L and R those of the cells beside
    /// them beyond vertical sides. Down: sides ac and bd are the diagonals; up: cb and da.
    HWY_ATTR void horizontal(int y) {
        const Cells &above = row(y + ring - 1), &below = row(y);
        const Floats one(1.0f), zero(0.0f);
        const int end = m_lattice.width() - 2, lanes = int(hn::Lanes(D()));
        const int first = m_lattice.vertex_site(0, y);
        for (int x = 1; x < end; x += lanes) {
            const Floats down = below.down.load(x);
            const Floats z0 = above.guide.load(x), z1 = above.guide.load(x + 1);
            const Floats za = below.guide.load(x), zb = below.guide.load(x + 1);
            const Row& under = row(y + 1).guide;
            const Floats z2 = under.load(x), z3 = under.load(x + 1);
            const Floats zc = either(down, z3, z2), zd = either(down, z0, z1);
            // One of da and ac is vertical, the other half as steep as dc, which climbs two rows.
            const Floats a1 = za - zd, a2 = zc - za, b1 = zb - zd, b2 = zc - zb;
            Edges f;
            f.adc = Cost::face(a2 - a1, either(down, a1, a2));
            f.bcd = Cost::face(b1 - b2, either(down, b2, b1));
            f.edge = below.top_cost.load(x);
            const Floats below_diagonal = below.diagonal_cost.load(x),
                         above_diagonal = above.diagonal_cost.load(x);
            f.side[0] = either(down, below_diagonal, below.left_cost.load(x));
            f.side[1] = either(down, below.left_cost.load(x + 1), below_diagonal);
            f.side[2] = either(down, above_diagonal, above.left_cost.load(x + 1));
            f.side[3] = either(down, above.left_cost.load(x), above_diagonal);
            const Face under_face = below.bottom.load(x), over_face = above.top.load(x);
            f.beyond[0] = either(down, under_face, below.right.load(x - 1));
            f.beyond[1] = either(down, below.left.load(x + 1), under_face);
            f.beyond[2] = either(down, over_face, above.left.load(x + 1));
            f.beyond[3] = either(down, above.right.load(x - 1), over_face);
            f.wx = down;
            f.wy = one;
            f.ux = one - down;
            f.uy = zero - one;
            const Floats flippable = same(down, above.down.load(x));
            const auto along = [&]() HWY_ATTR {
                return turned(down, above.xy.load(x) + below.xy.load(x)) -
                       (above.yy.load(x) + below.yy.load(x));
            };
            const Floats gains = either(flippable, gain(f, along), Floats(no_gain));
            store_gains(first + 2 * x, end - x, Floats(no_gain), gains);
            count(flippable, end - x);
            propose(gains, first + 2 * x + 1, end - x);
        }
        add_candidates();
    }

    /// Gains of the diagonals of row y of cells and of the vertical edges between them.
    HWY_ATTR void odd_row(int y) {
        const int end = m_lattice.width() - 1, lanes = int(hn::Lanes(D()));
        const int first = m_lattice.site(0, 2 * y + 1);
        for (int x = 1; x < end; x += lanes) {
            Floats flippable;
            const Floats verticals = vertical(y, x, flippable);
            const Floats diagonals = diagonal(y, x);
            store_gains(first + 2 * x, end - x, verticals, diagonals);
            count(flippable, end - x);
            propose(verticals, first + 2 * x, end - x);
            propose(diagonals, first + 2 * x + 1, end - 1 - x);
        }
        m_evaluations += std::max(end - 2, 0); // all diagonals
        add_candidates();
    }

    /// Gain of the edge ab on the left of cell x: the same turned.
    ///
    ///       both down                          both up
    ///     +---------+---------+             +---------+---------+
    ///     |    B    |    B    |  row y - 1  |    B    |    B    |
    ///     c ------- a ------- +             + ------- a ------- d
    ///     |  \      |  \   R  |             |  L   /  |      /  |
    ///     |     \   |     \   |  row y      |   /     |   /     |
    ///     |  L    \ |       \ |             | /       | /    R  |
    ///     + ------- b ------- d             c ------- b ------- +
    ///     |    T    |    T    |  row y + 1  |    T    |    T    |
    ///     +---------+---------+             +---------+---------+
    ///
    /// Down: sides cb and da are the diagonals; up: ac and bd.
    HWY_INLINE Floats vertical(int y, int x, Floats& flippable) {
        const Cells &above = row(y + ring - 1), &cells = row(y), &below = row(y + 1);
        const Floats one(1.0f), zero(0.0f);
        const Floats down = cells.down.load(x);
        flippable = same(down, cells.down.load(x - 1));
        const Floats za = cells.guide.load(x), zb = below.guide.load(x);
        const Floats zc = either(down, cells.guide.load(x - 1), below.guide.load(x - 1));
        const Floats zd = either(down, below.guide.load(x + 1), cells.guide.load(x + 1));
        const Floats a1 = za - zc, a2 = zd - za, b1 = zb - zc, b2 = zd - zb;
        Edges f;
        f.adc = Cost::face(either(down, a1, a2), a2 - a1);
        f.bcd = Cost::face(either(down, b2, b1), b1 - b2);
        f.edge = cells.left_cost.load(x);
        const Floats left_diagonal = cells.diagonal_cost.load(x - 1),
                     right_diagonal = cells.diagonal_cost.load(x);
        f.side[0] = either(down, cells.top_cost.load(x - 1), left_diagonal);
        f.side[1] = either(down, left_diagonal, below.top_cost.load(x - 1));
        f.side[2] = either(down, below.top_cost.load(x), right_diagonal);
        f.side[3] = either(down, right_diagonal, cells.top_cost.load(x));
        const Face left_face = cells.left.load(x - 1), right_face = cells.right.load(x);
        f.beyond[0] = either(down, above.bottom.load(x - 1), left_face);
        f.beyond[1] = either(down, left_face, below.top.load(x - 1));
        f.beyond[2] = either(down, below.top.load(x), right_face);
        f.beyond[3] = either(down, right_face, above.bottom.load(x));
        f.wx = zero - one;
        f.wy = one - down;
        f.ux = one;
        f.uy = down;
        const auto along = [&]() HWY_ATTR {
            return turned(down, cells.xy.load(x - 1) + cells.xy.load(x)) -
                   (cells.xx.load(x - 1) + cells.xx.load(x));
        };
        return either(flippable, gain(f, along), Floats(no_gain));
    }

    /// Gain of the diagonal ab of cell x, whose flip needs nothing: a cell is a parallelogram.
    ///
    ///       down                    up
    ///            B                       B
    ///         a --- d                 c --- a
    ///       R |  \  | L             R |  /  | L
    ///         c --- b                 b --- d
    ///            T                       T
    HWY_INLINE Floats diagonal(int y, int x) {
        const Cells &above = row(y + ring - 1), &cells = row(y), &below = row(y + 1);
        const Floats one(1.0f), zero(0.0f);
        const Floats down = cells.down.load(x);
        const Face t = cells.other_top.load(x), b = cells.other_bottom.load(x);
        const Floats top = cells.top_cost.load(x), bottom = below.top_cost.load(x),
                     left = cells.left_cost.load(x), right = cells.left_cost.load(x + 1);
        const Face beyond_top = above.bottom.load(x), beyond_bottom = below.top.load(x),
                   beyond_left = cells.right.load(x - 1), beyond_right = cells.left.load(x + 1);
        Edges f;
        f.adc = t;
        f.bcd = b;
        f.edge = cells.diagonal_cost.load(x);
        f.side[0] = either(down, left, top);
        f.side[1] = either(down, bottom, left);
        f.side[2] = either(down, right, bottom);
        f.side[3] = either(down, top, right);
        f.beyond[0] = either(down, beyond_left, beyond_top);
        f.beyond[1] = either(down, beyond_bottom, beyond_left);
        f.beyond[2] = either(down, beyond_right, beyond_bottom);
        f.beyond[3] = either(down, beyond_top, beyond_right);
        f.wx = down - one;
        f.wy = f.ux = down;
        f.uy = one - down;
        return gain(f, [&]() HWY_ATTR {
            const Floats xy = cells.xy.load(x);
            return either(down, xy + xy, zero - (xy + xy));
        });
    }

    /// Store gains in the records of the edges at `site`, site + 2, ... and of those beside them,
    /// of the first n lanes. What has none, no_gain, keeps its record. As many sites are read as
    /// two vectors have lanes.
    HWY_INLINE void store_gains(int site, int n, Floats first, Floats second) {
        const D d;
        const D64 d64;
        const hn::Rebind<uint32_t, D64> d32;
        const auto here = hn::FirstN(d, size_t(n));
        // Of a guide in steps all are far above least_gain.
        const auto none = hn::Set(d, no_gain);
        HWY_ALIGN float gains[2 * most_lanes];
        hn::StoreInterleaved2(hn::IfThenElse(here, first.v, none),
                              hn::IfThenElse(here, second.v, none), d, gains);
        auto* const records = reinterpret_cast<uint64_t*>(m_lattice.sites() + site);
        const auto low = hn::Set(d64, 0xffffffffu);
        const auto no =
            hn::PromoteTo(d64, hn::BitCast(d32, hn::Set(hn::Rebind<float, D64>(), no_gain)));
        for (size_t k = 0; k < 2 * hn::Lanes(d); k += hn::Lanes(d64)) {
            const auto gain =
                hn::PromoteTo(d64, hn::LoadU(d32, reinterpret_cast<const uint32_t*>(gains + k)));
            const auto record = hn::LoadU(d64, records + k);
            const auto changed = hn::Or(hn::And(record, low), hn::ShiftLeft<32>(gain));
            hn::StoreU(hn::IfThenElse(hn::Eq(gain, no), record, changed), d64, records + k);
        }
    }

    /// xy or, where the diagonals are down, -xy. contour_gain() of the edges that there are, where
    /// all products of w and u but two are 0; whole numbers, so in any order.
    static HWY_INLINE Floats turned(Floats down, Floats xy) {
        return either(down, Floats(0.0f) - xy, xy);
    }

    /// 1 where both flags are alike, else 0.
    static HWY_INLINE Floats same(Floats a, Floats b) {
        const D d;
        return hn::IfThenElseZero(hn::Eq(a.v, b.v), hn::Set(d, 1.0f));
    }

    /// Count the flags set in the first n lanes as evaluations.
    HWY_INLINE void count(Floats flags, int n) {
        const D d;
        const auto set =
            hn::And(hn::FirstN(d, size_t(n < 0 ? 0 : n)), hn::Gt(flags.v, hn::Zero(d)));
        m_evaluations += int64_t(hn::CountTrue(d, set));
    }

    /// Note the edges at `site`, site + 2, ... of the first n lanes that gain enough.
    HWY_INLINE void propose(Floats gained, int site, int n) {
        const D d;
        const DI di;
        const auto good =
            hn::And(hn::FirstN(d, size_t(n < 0 ? 0 : n)), hn::Gt(gained.v, hn::Set(d, m_min_gain)));
        const auto sites = hn::Add(hn::Set(di, site), hn::ShiftLeft<1>(hn::Iota(di, 0)));
        // Branch-free: the branch would be mispredicted.
        m_number += store_compressed(sites, hn::RebindMask(di, good), m_found.data() + m_number);
    }

    void add_candidates() {
        append(m_w.candidates, m_found.data(), m_number);
        m_number = 0;
    }

    Lattice& m_lattice;
    float m_contour; ///< as in gain_at()
    float m_min_gain;
    Workspace& m_w;
    int64_t m_evaluations = 0;
    Cells m_rows[ring];
    std::vector<int32_t> m_found; ///< a row's candidates, with room for whole vectors
    size_t m_number = 0;          ///< of them
};
