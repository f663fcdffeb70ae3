// SPDX-License-Identifier: Apache-2.0
#include "core/surface/kept_rows.h"

#include <algorithm>
#include <cstring>

namespace ddt {

namespace {

/// Have so many numbers there, whatever they are.
template <class Numbers>
void take(Numbers& kept, size_t floats) {
    const size_t size = floats + edge_padding;
    if (kept.size() >= size)
        return;
    Numbers(kept.get_allocator()).swap(kept); // nothing in it is of use
    kept.resize(size);
}

/// Floats of rows_memory().
size_t floats_of(int width, int height, int count, int rows) {
    return size_t(std::min(rows + rows_to_go_on, height)) * site_row(width, count);
}

} // namespace

void take_memory(std::vector<float>& kept, size_t floats) {
    take(kept, floats);
}

size_t rows_memory(int width, int height, int count, int rows) {
    return (floats_of(width, height, count, rows) + edge_padding) * sizeof(float) + Arena::line;
}

void take_rows(const Lattice& lattice, int count, int first, int rows, Arena* arena,
               SiteRows& kept) {
    if (arena || kept.numbers.get_allocator().arena)
        kept.numbers = ArenaVector<float>(arena);
    take(kept.numbers, floats_of(lattice.width(), lattice.height(), count, rows));
    kept.count = count;
    kept.first = lattice.vertex_site(0, first);
}

void make_room(const Lattice& lattice, int keep, int made, int end, SiteRows& kept) {
    ArenaVector<float>& numbers = kept.numbers;
    const size_t row = site_row(lattice.width(), kept.count);
    int first = kept.first / lattice.vertex_site(0, 1);
    const auto has_room = [&] {
        return end <= first || size_t(end - first) * row + edge_padding <= numbers.size();
    };
    if (has_room())
        return;
    const int from = std::clamp(keep, first, std::max(first, made));
    if (made > from && from > first)
        std::memmove(numbers.data(), numbers.data() + size_t(from - first) * row,
                     size_t(made - from) * row * sizeof(float));
    first = from;
    kept.first = lattice.vertex_site(0, first);
    if (has_room())
        return;
    // A vector that grows by itself would take up to twice of it.
    if (made <= from)
        ArenaVector<float>(numbers.get_allocator()).swap(numbers);
    numbers.reserve(size_t(std::min(end - first + rows_to_go_on, lattice.height())) * row +
                    edge_padding);
    numbers.resize(numbers.capacity());
}

} // namespace ddt
