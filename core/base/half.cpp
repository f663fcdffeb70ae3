// SPDX-License-Identifier: Apache-2.0
#include "core/base/half.h"

#include "core/base/float_mode.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/base/half.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {

HWY_ATTR void floats_of_halfs(const uint16_t* halfs, size_t n, float* floats) {
    for (size_t i = 0; i < n; ++i)
        floats[i] = float_of_half(halfs[i]);
}

HWY_ATTR void halfs_of_floats(const float* floats, size_t n, uint16_t* halfs) {
    for (size_t i = 0; i < n; ++i)
        halfs[i] = half_of_float(floats[i]);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(floats_of_halfs);
HWY_EXPORT(halfs_of_floats);

void floats_of_halfs(const uint16_t* halfs, size_t n, float* floats) {
    const DenormalsAreZero as_on_gpus;
    HWY_DYNAMIC_DISPATCH(floats_of_halfs)(halfs, n, floats);
}

void halfs_of_floats(const float* floats, size_t n, uint16_t* halfs) {
    const DenormalsAreZero as_on_gpus;
    HWY_DYNAMIC_DISPATCH(halfs_of_floats)(floats, n, halfs);
}

} // namespace ddt
#endif
