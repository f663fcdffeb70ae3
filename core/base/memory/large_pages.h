// SPDX-License-Identifier: Apache-2.0
// Large pages for large memory.
#pragma once

#include <cstddef>
#include <vector>

namespace ddt {

/// Ask the system to back memory that is about to be written by large pages: to be given 4 KiB at a
/// time takes longer than to fill them. It is no matter if there are none.
void ask_for_large_pages(const void* begin, size_t bytes);

/// Take the memory for n numbers, by large pages if there are.
template <class T>
void reserve_large(std::vector<T>& v, size_t n) {
    if (n <= v.capacity())
        return;
    v.reserve(n);
    ask_for_large_pages(v.data(), n * sizeof(T));
}

} // namespace ddt
