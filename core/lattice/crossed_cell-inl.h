// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for each SIMD target: T is a vector of floats, of positions.
// Needs: arith.h.

/// The weights of the positions x, y in a triangle that crosses their cell.
template <class T>
struct CrossingWeights {
    T b0, b1, b2;

    /// Planes: CellPlanes, or the same a lane.
    template <class Planes>
    DDT_INLINE CrossingWeights(const Planes& t, T x, T y)
        : b0((T(t.across[0][0]) * y - T(t.across[0][1]) * x) + T(t.offset[0])),
          b1((T(t.across[1][0]) * y - T(t.across[1][1]) * x) + T(t.offset[1])),
          b2((T(1.0f) - b0) - b1) {}
};
