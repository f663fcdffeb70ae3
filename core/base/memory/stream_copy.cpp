// SPDX-License-Identifier: Apache-2.0
#include "core/base/memory/stream_copy.h"

#include <algorithm>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/base/memory/stream_copy.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

HWY_ATTR void stream_copy(const float* from, size_t n, float* to) {
    // Lines of 64 bytes, whatever a vector is: those written in part are read.
    constexpr size_t line = 64, floats = line / sizeof(float);
    const hn::CappedTag<float, floats> d;
    const size_t lanes = hn::Lanes(d);
    if (reinterpret_cast<uintptr_t>(to) % sizeof(float) != 0) { // no float begins a line
        std::copy_n(from, n, to);
        return;
    }
    const size_t head = std::min(n, (0 - reinterpret_cast<uintptr_t>(to)) % line / sizeof(float));
    std::copy_n(from, head, to);
    size_t i = head;
    for (; i + floats <= n; i += floats)
        for (size_t k = 0; k < floats; k += lanes)
            hn::Stream(hn::LoadU(d, from + i + k), d, to + i + k);
    std::copy_n(from + i, n - i, to + i);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(stream_copy);

void stream_copy(const float* from, size_t n, float* to) {
    HWY_DYNAMIC_DISPATCH(stream_copy)(from, n, to);
}

void finish_streams() {
    hwy::FlushStream();
}

} // namespace ddt
#endif
