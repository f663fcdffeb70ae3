// SPDX-License-Identifier: Apache-2.0
// On which nodes of memory the pages of a result lie that was not there before: what
// core/tiles/tile_order.h is for.
//
//   nodes [SIZE [SCALE [THREADS]]]
//
// Enlarges SIZE x SIZE pixels of noise (1536), RGB, SCALE times (2), by so many threads (all), and
// prints for each row of tiles how many of its pages each node has. A page that the system is about
// to move is of no node (kernel.numa_balancing=1).
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <vector>

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/tiles/grid.h"
#include "ddt/core.h"
#include "tests/bench/arguments.h"
#include "tests/core/random.h"

namespace {

constexpr int channels = 3;

std::vector<float> noise(int size) {
    std::vector<float> pixels(size_t(size) * size_t(size) * channels);
    ddt::test::Random random(1);
    for (float& x : pixels)
        x = random.unit();
    return pixels;
}

/// Pages that begin in [begin, end) on each node; below 0: on none. Nothing if the system does not
/// tell.
std::map<int, size_t> count_pages(char* begin, char* end) {
    const auto size = size_t(sysconf(_SC_PAGESIZE));
    std::vector<void*> pages;
    for (char* page = begin + (size - uintptr_t(begin) % size) % size; page < end; page += size)
        pages.push_back(page);
    std::vector<int> nodes(pages.size(), -1);
    std::map<int, size_t> counts;
    if (syscall(SYS_move_pages, 0, pages.size(), pages.data(), nullptr, nodes.data(), 0) < 0)
        return counts;
    for (const int node : nodes)
        ++counts[std::max(node, -1)];
    return counts;
}

} // namespace

int main(int argc, char** argv) {
    int size = 1536, scale = 2, threads = 0;
    if (argc > 4 || (argc > 1 && !bench::parse_argument("SIZE", argv[1], 1, 16384, size)) ||
        (argc > 2 && !bench::parse_argument("SCALE", argv[2], 1, 16, scale)) ||
        (argc > 3 && !bench::parse_argument("THREADS", argv[3], 0, 1024, threads))) {
        std::fprintf(stderr, "nodes [SIZE [SCALE [THREADS]]]\n");
        return 2;
    }
    const std::vector<float> source = noise(size);
    const size_t row = size_t(size) * size_t(scale) * channels * sizeof(float);
    const size_t bytes = row * size_t(size) * size_t(scale);
    void* const memory =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        std::fprintf(stderr, "nodes: out of memory\n");
        return 1;
    }
    madvise(memory, bytes, MADV_NOHUGEPAGE); // of which the system tells no node
    std::string error;
    if (ddt::enlarge(source.data(), size, size, channels, nullptr, static_cast<float*>(memory),
                     size * scale, size * scale, {}, {}, threads, &error) != ddt::Outcome::done) {
        std::fprintf(stderr, "nodes: %s\n", error.c_str());
        return 1;
    }
    const size_t tile = row * ddt::tile_size * size_t(scale);
    auto* const result = static_cast<char*>(memory);
    for (size_t at = 0, number = 0; at < bytes; at += tile, ++number) {
        const auto counts = count_pages(result + at, result + std::min(bytes, at + tile));
        if (counts.empty()) {
            std::perror("nodes: move_pages");
            return 1;
        }
        std::printf("tiles of row %zu:", number);
        for (const auto& [node, pages] : counts)
            if (node < 0)
                std::printf("  no node %zu", pages);
            else
                std::printf("  node %d %zu", node, pages);
        std::printf(" pages\n");
    }
    return 0;
}
