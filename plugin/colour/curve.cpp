// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/curve.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugin/colour/curve.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;

/// The bits of a float without its sign.
HWY_INLINE hn::Vec<DI> size_of(hn::Vec<D> x) {
    return hn::And(hn::BitCast(DI(), x), hn::Set(DI(), 0x7fffffff));
}

HWY_INLINE hn::Vec<D> look_up(const float* values, hn::Vec<D> x) {
    const D d;
    const DI di;
    const auto size = size_of(x), first = hn::Set(di, int32_t(Curve::first));
    const auto small = hn::Lt(size, first);
    const auto sign = hn::BroadcastSignBit(hn::BitCast(di, x));
    const auto half = hn::And(sign, hn::Set(di, int32_t(Curve::half)));
    const auto point = hn::Add(hn::ShiftRight<Curve::shift>(hn::Sub(size, first)), hn::Set(di, 1));
    const auto index = hn::Add(half, hn::IfThenZeroElse(small, point));
    const auto v0 = hn::GatherIndex(d, values, index);
    const auto v1 = hn::GatherIndex(d, values + 1, index);
    const auto fraction = hn::And(size, hn::Set(di, (1 << Curve::shift) - 1));
    const auto t = hn::IfThenElse(
        hn::RebindMask(d, small), hn::Mul(hn::BitCast(d, size), hn::Set(d, 1.0f / Curve::lowest)),
        hn::Mul(hn::ConvertTo(d, fraction), hn::Set(d, 1.0f / (1 << Curve::shift))));
    return hn::Add(v0, hn::Mul(hn::Sub(v1, v0), t));
}

/// Whole vectors only; returns how many numbers they hold, or 0 if one of these is not covered.
HWY_ATTR size_t apply(const float* values, float* x, size_t n) {
    const D d;
    const DI di;
    const size_t lanes = hn::Lanes(d), end = n - n % lanes;
    auto largest = hn::Zero(di);
    for (size_t i = 0; i < end; i += lanes)
        largest = hn::Max(largest, size_of(hn::LoadU(d, x + i)));
    const auto last = hn::Set(di, int32_t(Curve::last));
    if (!hn::AllTrue(di, hn::Lt(largest, last)))
        return 0;
    for (size_t i = 0; i < end; i += lanes)
        hn::StoreU(look_up(values, hn::LoadU(d, x + i)), d, x + i);
    return end;
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(apply);

std::vector<float> Curve::arguments() {
    std::vector<float> x;
    x.reserve(2 * half);
    for (const float sign : {1.0f, -1.0f}) {
        x.push_back(0.0f);
        for (uint32_t u = first; u <= last; u += 1u << shift)
            x.push_back(sign * float_of(u));
    }
    return x;
}

void Curve::fill(const float* values) {
    m_values.assign(values, values + 2 * half);
}

size_t Curve::apply(float* x, size_t n) const {
    return HWY_DYNAMIC_DISPATCH(apply)(m_values.data(), x, n);
}

} // namespace ddt
#endif
