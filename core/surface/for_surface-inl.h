// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: what a surface is made of, as constants.
// Needs: <type_traits>, control_net.h.

/// Call f(quadratic, soft) with what a net's surface is made of, as integral constants.
template <class F>
HWY_INLINE void for_surface(const ControlNet& net, Surface surface, F&& f) {
    const std::true_type yes;
    const std::false_type no;
    const bool soft = !net.soft.empty();
    if (surface == Surface::linear && soft)
        f(no, yes);
    else if (surface == Surface::linear)
        f(no, no);
    else if (soft)
        f(yes, yes);
    else
        f(yes, no);
}
