// SPDX-License-Identifier: Apache-2.0
#include "core/base/zero_small.h"

#include "core/base/float_bits.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/base/zero_small.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {

// Loops that compilers make vectors of.

HWY_ATTR void zero_small(float* values, size_t n, float least) {
    const uint32_t limit = bits_of(least);
    for (size_t i = 0; i < n; ++i)
        values[i] = (bits_of(values[i]) & 0x7fffffffu) < limit ? 0.0f : values[i];
}

HWY_ATTR void zero_unusual(float* values, size_t n, float least) {
    const uint32_t limit = bits_of(least), usual = 0x7f800000u - limit;
    for (size_t i = 0; i < n; ++i)
        values[i] = (bits_of(values[i]) & 0x7fffffffu) - limit < usual ? values[i] : 0.0f;
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(zero_small);
HWY_EXPORT(zero_unusual);

void zero_small(float* values, size_t n, float least) {
    HWY_DYNAMIC_DISPATCH(zero_small)(values, n, least);
}

void zero_unusual(float* values, size_t n, float least) {
    HWY_DYNAMIC_DISPATCH(zero_unusual)(values, n, least);
}

} // namespace ddt
#endif
