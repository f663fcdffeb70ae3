// SPDX-License-Identifier: Apache-2.0
#include "core/surface/kept_rows.h"

#include <cstring>

namespace ddt {

void make_room(std::vector<float>& kept, size_t row, int more, int height, int& first, int keep,
               int made, int end) {
    if (size_t(end - first) * row + edge_padding <= kept.size())
        return;
    const int from = std::clamp(keep, first, std::max(first, made));
    if (made > from && from > first)
        std::memmove(kept.data(), kept.data() + size_t(from - first) * row,
                     size_t(made - from) * row * sizeof(float));
    first = from;
    if (size_t(end - first) * row + edge_padding <= kept.size())
        return;
    // A vector that grows by itself would take up to twice of it.
    if (made <= from)
        std::vector<float>().swap(kept);
    kept.reserve(size_t(std::min(end - first + more, height)) * row + edge_padding);
    kept.resize(kept.capacity());
}

void take_memory(std::vector<float>& kept, size_t row, int rows) {
    const size_t size = size_t(rows) * row + edge_padding;
    if (kept.size() >= size)
        return;
    std::vector<float>().swap(kept); // nothing in it is of use
    kept.resize(size);
}

} // namespace ddt
