// SPDX-License-Identifier: Apache-2.0
#include "core/surface/tame.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/tame.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

HWY_ATTR bool all_tame(const float* values, size_t n) {
    const hn::ScalableTag<float> d;
    const auto most = hn::Set(d, tame_value);
    const size_t lanes = hn::Lanes(d);
    size_t i = 0;
    auto tame = hn::FirstN(d, lanes);
    for (; i + lanes <= n; i += lanes)
        tame = hn::And(tame, hn::Le(hn::Abs(hn::LoadU(d, values + i)), most));
    bool all = hn::AllTrue(d, tame);
    for (; i < n; ++i)
        all &= values[i] >= -tame_value && values[i] <= tame_value;
    return all;
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(all_tame);

bool all_tame(const float* values, size_t n) {
    return HWY_DYNAMIC_DISPATCH(all_tame)(values, n);
}

} // namespace ddt
#endif
