// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: rows of a starting lattice's cells, several of them in
// the lanes: what start_gains.cpp keeps of a cell while it goes down the rows.
// Needs: <cstring>, <vector>, row_lanes.h, lanes-inl.h, Floats = Lanes<D>.

/// A row of numbers, with room for whole vectors before its begin and past its end. Those from
/// number 1 on are aligned: vectors that are not touch two lines of the cache each.
class Row {
public:
    void resize(int n) {
        constexpr size_t aligned = most_lanes * sizeof(float);
        m_numbers.resize(size_t(n) + 4 * most_lanes);
        const size_t past = reinterpret_cast<uintptr_t>(m_numbers.data()) % aligned;
        m_first = m_numbers.data() + 2 * most_lanes - 1 - past / sizeof(float);
    }
    float* at(int x) { return m_first + x; }
    const float* at(int x) const { return m_first + x; }
    HWY_INLINE Floats load(int x) const { return Floats::load(at(x)); }
    HWY_INLINE void store(int x, Floats v) { v.store(at(x)); }

private:
    std::vector<float> m_numbers;
    float* m_first = nullptr; ///< number 0
};

/// A row of what a cost needs to know of triangles.
template <class Face>
class FaceRow {
public:
    static constexpr int parts = sizeof(Face) / sizeof(Floats);
    void resize(int n) {
        for (Row& row : m_parts)
            row.resize(n);
    }
    HWY_INLINE Face load(int x) const {
        Floats part[parts];
        for (int k = 0; k < parts; ++k)
            part[k] = m_parts[k].load(x);
        Face face;
        std::memcpy(static_cast<void*>(&face), part, sizeof face);
        return face;
    }
    HWY_INLINE void store(int x, const Face& face) {
        Floats part[parts];
        std::memcpy(static_cast<void*>(part), &face, sizeof face);
        for (int k = 0; k < parts; ++k)
            m_parts[k].store(x, part[k]);
    }

private:
    Row m_parts[parts];
};

/// either() of each number of two faces.
template <class T>
HWY_INLINE T either(Floats flag, const T& yes, const T& no) {
    constexpr int parts = sizeof(T) / sizeof(Floats);
    Floats a[parts], b[parts];
    std::memcpy(static_cast<void*>(a), &yes, sizeof yes);
    std::memcpy(static_cast<void*>(b), &no, sizeof no);
    for (int k = 0; k < parts; ++k)
        a[k] = if_less(Floats(0.0f), flag, a[k], b[k]);
    T result;
    std::memcpy(static_cast<void*>(&result), a, sizeof result);
    return result;
}

/// A row of cells. "Down" is the diagonal from upper left to lower right.
template <class Face>
struct DividedCells {
    Row guide;                              ///< at the vertices on top
    Row down;                               ///< 1 where the diagonal is down, else 0
    FaceRow<Face> top, bottom;              ///< the triangles at the cell's horizontal sides,
    FaceRow<Face> left, right;              ///< the same two by its vertical sides
    FaceRow<Face> other_top, other_bottom;  ///< those that the other diagonal would make
    Row top_cost, left_cost, diagonal_cost; ///< of the edges as they stand
    Row xx, yy, xy;                         ///< the integers of the contour words

    void resize(int n) {
        for (Row* row : {&guide, &down, &top_cost, &left_cost, &diagonal_cost, &xx, &yy, &xy})
            row->resize(n);
        for (FaceRow<Face>* row : {&top, &bottom, &left, &right, &other_top, &other_bottom})
            row->resize(n);
    }
};
