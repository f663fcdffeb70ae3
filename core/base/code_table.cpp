// SPDX-License-Identifier: Apache-2.0
#include "ddt/code_table.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/base/code_table.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

/// GLSL twin: encode() in shaders/codes.glsl.
template <class D>
HWY_INLINE void encode_vector(D d, const CodeTable& t, const float* x, uint8_t* codes) {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const auto lowest = hn::Set(d, t.lowest), top = hn::Set(d, t.top);
    auto v = hn::LoadU(d, x);
    v = hn::IfThenElse(hn::Lt(lowest, v), v, lowest); // NaN too
    v = hn::IfThenElse(hn::Lt(v, top), v, top);
    const auto bits = hn::BitCast(du, v);
    const auto index = hn::Sub(hn::ShiftRightSame(bits, t.shift), hn::Set(du, t.first));
    const auto entry = hn::GatherIndex(du, t.entries.data(), hn::BitCast(di, index));
    const auto within = hn::BitCast(di, hn::And(bits, hn::Set(du, (1u << unsigned(t.shift)) - 1)));
    const auto border = hn::BitCast(di, hn::And(entry, hn::Set(du, 0xffffffu)));
    const auto begin = hn::BitCast(di, hn::ShiftRight<24>(entry));
    const auto one = hn::Set(di, 1), zero = hn::Zero(di);
    const auto code = hn::Add(begin, hn::IfThenElse(hn::Gt(border, within), zero, one));
    hn::StoreU(hn::DemoteTo(hn::Rebind<uint8_t, decltype(di)>(), code),
               hn::Rebind<uint8_t, decltype(di)>(), codes);
}

HWY_ATTR void encode_all(const CodeTable& t, const float* x, uint8_t* codes, size_t n) {
    const hn::ScalableTag<float> d;
    const size_t lanes = hn::Lanes(d);
    size_t i = 0;
    for (; i + lanes <= n; i += lanes)
        encode_vector(d, t, x + i, codes + i);
    for (; i < n; ++i)
        encode_vector(hn::CappedTag<float, 1>(), t, x + i, codes + i);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(encode_all);

void CodeTable::encode(const float* x, uint8_t* codes, size_t n) const noexcept {
    HWY_DYNAMIC_DISPATCH(encode_all)(*this, x, codes, n);
}

} // namespace ddt
#endif
