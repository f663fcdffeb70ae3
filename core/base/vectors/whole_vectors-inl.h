// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: n things in a row by whole vectors, of what may be
// done twice. Needs: <algorithm>, vectors-inl.h.

/// Call f(x) for vectors of so many that begin at x and cover 0 .. n - 1, the last repeating some
/// of the one before; for none if they would not fill one. Returns how many are covered: all or
/// none.
template <class F>
HWY_INLINE int each_whole_vector(int n, int lanes, F&& f) {
    if (n < lanes)
        return 0;
    for (int done = 0; done < n; done += lanes)
        f(std::min(done, n - lanes));
    return n;
}
