// SPDX-License-Identifier: Apache-2.0
#include "core/base/codes.h"

#include "core/base/float_mode.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/base/codes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {

// Loops that compilers make vectors of.

HWY_ATTR void bytes_of_floats(const float* floats, size_t n, uint8_t* codes) {
    for (size_t i = 0; i < n; ++i)
        codes[i] = code_of<uint8_t>(floats[i]);
}

HWY_ATTR void shorts_of_floats(const float* floats, size_t n, uint16_t* codes) {
    for (size_t i = 0; i < n; ++i)
        codes[i] = code_of<uint16_t>(floats[i]);
}

HWY_ATTR void floats_of_bytes(const uint8_t* codes, size_t n, float* floats) {
    for (size_t i = 0; i < n; ++i)
        floats[i] = float_of_code(codes[i]);
}

HWY_ATTR void floats_of_shorts(const uint16_t* codes, size_t n, float* floats) {
    for (size_t i = 0; i < n; ++i)
        floats[i] = float_of_code(codes[i]);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(bytes_of_floats);
HWY_EXPORT(shorts_of_floats);
HWY_EXPORT(floats_of_bytes);
HWY_EXPORT(floats_of_shorts);

void codes_of_floats(const float* floats, size_t n, uint8_t* codes) {
    const DenormalsAreZero as_on_gpus;
    HWY_DYNAMIC_DISPATCH(bytes_of_floats)(floats, n, codes);
}

void codes_of_floats(const float* floats, size_t n, uint16_t* codes) {
    const DenormalsAreZero as_on_gpus;
    HWY_DYNAMIC_DISPATCH(shorts_of_floats)(floats, n, codes);
}

void floats_of_codes(const uint8_t* codes, size_t n, float* floats) {
    const DenormalsAreZero as_on_gpus;
    HWY_DYNAMIC_DISPATCH(floats_of_bytes)(codes, n, floats);
}

void floats_of_codes(const uint16_t* codes, size_t n, float* floats) {
    const DenormalsAreZero as_on_gpus;
    HWY_DYNAMIC_DISPATCH(floats_of_shorts)(codes, n, floats);
}

} // namespace ddt
#endif
