// SPDX-License-Identifier: Apache-2.0
#include "core/base/vectors/gathers.h"

#include <atomic>

#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#endif

namespace ddt {

namespace {

bool detect() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    unsigned a, b, c, d;
    // SERIALIZE came with the first of them.
    return __builtin_cpu_is("intel") && __get_cpuid_count(7, 0, &a, &b, &c, &d) && (d >> 14 & 1);
#else
    return false;
#endif
}

std::atomic<bool>& quick() {
    static std::atomic<bool> is_quick(detect());
    return is_quick;
}

} // namespace

bool gathers_are_quick() {
    return quick().load(std::memory_order_relaxed);
}

void set_gathers_are_quick(bool to) {
    quick().store(to, std::memory_order_relaxed);
}

} // namespace ddt
