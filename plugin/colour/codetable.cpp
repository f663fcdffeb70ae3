// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/codetable.h"

#include <algorithm>
#include <array>

#include "plugin/colour/codes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugin/colour/codetable.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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

namespace {

constexpr uint32_t no_border = 0xffffff;

/// Bits of the first float whose code is not below `code`; the curve rises.
uint32_t border_of(const Curve& curve, int code) {
    uint32_t below = 0, at = Curve::last - 1;
    while (at - below > 1) {
        const uint32_t middle = below + (at - below) / 2;
        (code_of<uint8_t>(curve(Curve::mag(middle))) < code ? below : at) = middle;
    }
    return at;
}

} // namespace

bool CodeTable::fill(const Curve& curve) {
    const float *positive = curve.values(), *negative = positive + Curve::half;
    if (!std::is_sorted(positive, negative) || code_of<uint8_t>(positive[0]) != 0 ||
        code_of<uint8_t>(curve(Curve::mag(Curve::last - 1))) != 255 ||
        std::any_of(negative, negative + Curve::half, code_of<uint8_t>))
        return false;
    std::array<uint32_t, 256> borders{};
    for (int code = 1; code < 256; ++code)
        borders[size_t(code)] = border_of(curve, code);
    const auto meet = [&](uint32_t a, uint32_t b) { return a >> shift == b >> shift; };
    for (shift = 17; std::adjacent_find(borders.begin() + 1, borders.end(), meet) != borders.end();)
        if (--shift < 12)
            return false; // steps rather than a curve
    first = borders[1] >> shift;
    lowest = Curve::mag(first << shift);
    top = Curve::mag(borders[255]);
    // Should the first piece begin with its border, what is below it must still be 0.
    if (borders[1] == first << shift)
        lowest = Curve::mag(--first << shift);
    entries.clear();
    for (uint32_t piece = first, code = 0; piece <= borders[255] >> shift; ++piece) {
        const bool border = code < 255 && borders[code + 1] >> shift == piece;
        const uint32_t within = borders[std::min(code + 1, 255u)] & ((1u << unsigned(shift)) - 1);
        entries.push_back(code << 24 | (border ? within : no_border));
        code += border;
    }
    return true;
}

void CodeTable::encode(const float* x, uint8_t* codes, size_t n) const {
    HWY_DYNAMIC_DISPATCH(encode_all)(*this, x, codes, n);
}

} // namespace ddt
#endif
