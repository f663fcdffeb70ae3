// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: fitted bends of regular edges (edge_kinds.h).
// Needs: edge_kinds.h, fitted.h, features-inl.h, row_lanes-inl.h.

/// An address that in each lane is one of two: by flag `k`, `yes` where it is 1.
template <int k>
struct Either {
    ptrdiff_t yes, no;
    friend HWY_INLINE Either operator+(Either a, Either b) { return {a.yes + b.yes, a.no + b.no}; }
    friend HWY_INLINE Either operator+(ptrdiff_t a, Either b) { return {a + b.yes, a + b.no}; }
    friend HWY_INLINE Either operator+(Either a, ptrdiff_t b) { return b + a; }
    friend HWY_INLINE Either operator*(int i, Either a) { return {i * a.yes, i * a.no}; }
    friend HWY_INLINE Either half_of(Either a) { return {a.yes / 2, a.no / 2}; }
};

/// Reads what lies in lanes at an address.
template <class T>
struct Tap {
    const float* first;
    T flag[2];

    HWY_INLINE T operator()(ptrdiff_t at) const { return T::load(first + at); }
    template <int k>
    HWY_INLINE T operator()(Either<k> at) const {
        return either(flag[k], T::load(first + at.yes), T::load(first + at.no));
    }
};

/// What edges of a kind at or beside the vertices of row y of pixels are made from, from column 0
/// on: those that are this far from the rim at least.
class RegularBends {
public:
    static constexpr int margin = 3;

    HWY_INLINE RegularBends(const FittedSource& source, const IndexRows& index,
                            const ControlNet& plain, const BendScratch& scratch, int y)
        : m_here(source.at(0, y)), m_down{scratch.cells.above(y), scratch.cells.below(y)},
          m_index{index.at(0, y), index.at(0, y + 1)}, m_plain(plain), m_scratch(scratch),
          m_count(source.count), m_row(ptrdiff_t(source.lattice.width()) * source.count) {}

    /// first: the site of the one in column 0.
    template <EdgeKind kind, class T>
    HWY_INLINE T at(const RowPlace& place, int first) const {
        const FittedTable& table = fitted_table();
        const auto down = [&](int dx, int dy)
                              HWY_ATTR { return spread<T>(m_down[dy + 1] + dx, place, m_count); };
        const auto index = [&](int dx, int dy)
                               HWY_ATTR { return T::load(m_index[dy] + place.at + dx * m_count); };
        const ptrdiff_t right = m_count, below = m_row;
        const T plain = T::load(m_plain.at(first) + place.at);
        const float* const here = m_here + place.at;
        EdgeFeatures<T> f;
        T both; // ends' indices
        // As RegularRow::edges() of edges.cpp has them; apexes are relative to the midpoint in
        // doubled coordinates.
        if constexpr (kind == EdgeKind::horizontal) {
            f.find_any(ptrdiff_t(0), right, Either<0>{right + 2 * below, 2 * below - right},
                       Either<1>{-right - 2 * below, right - 2 * below}, plain,
                       Tap<T>{here, {down(0, 0), down(0, -1)}});
            both = index(0, 0) + index(1, 0);
        } else if constexpr (kind == EdgeKind::vertical) {
            f.find_any(ptrdiff_t(0), below, Either<0>{-below - 2 * right, below - 2 * right},
                       Either<1>{below + 2 * right, 2 * right - below}, plain,
                       Tap<T>{here, {down(-1, 0), down(0, 0)}});
            both = index(0, 0) + index(0, 1);
        } else {
            const T flag = down(0, 0);
            f.find_any(Either<0>{0, right}, Either<0>{right + below, below - right},
                       Either<0>{below - right, -right - below},
                       Either<0>{right - below, right + below}, plain, Tap<T>{here, {flag, flag}});
            both = either(flag, index(0, 0) + index(1, 1), index(1, 0) + index(0, 1));
        }
        constexpr bool odd = in_odd_column(kind), diagonal = kind == EdgeKind::diagonal;
        const T near = spread<T>(m_scratch.near[odd].data(), place, m_count);
        const T flippable = spread<T>(m_scratch.flippable[odd].data(), place, m_count);
        const auto& kinds = table.null[fitted_length(1, diagonal)];
        const auto null = [&](int k, int i) HWY_ATTR {
            const T weight = T(kinds[1][k][i]) + near * T(kinds[2][k][i]);
            // A cell's own diagonal can be flipped.
            return diagonal ? weight : either(flippable, weight, T(kinds[0][k][i]));
        };
        return fitted_bend(f, both * T(0.5f), null, table);
    }

private:
    const float* m_here;
    const float* m_down[2];
    const float* m_index[2];
    const ControlNet& m_plain;
    const BendScratch& m_scratch;
    const int m_count;
    const ptrdiff_t m_row;
};
