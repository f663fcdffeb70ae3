// SPDX-License-Identifier: Apache-2.0
#include "core/base/memory/large_pages.h"

#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>

namespace ddt {

void ask_for_large_pages(const void* begin, size_t bytes) {
#ifdef MADV_HUGEPAGE
    // Less holds no large page, but much that is not ours.
    constexpr size_t least = size_t(4) << 20;
    static const auto page = uintptr_t(sysconf(_SC_PAGESIZE));
    const auto at = reinterpret_cast<uintptr_t>(begin);
    const uintptr_t first = (at + page - 1) / page * page, last = (at + bytes) / page * page;
    if (begin && bytes >= least)
        madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#else
    (void)begin, (void)bytes;
#endif
}

} // namespace ddt
