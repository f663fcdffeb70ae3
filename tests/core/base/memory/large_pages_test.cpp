// SPDX-License-Identifier: Apache-2.0
// A system whose pages have 64 KiB, as some of AArch64's and POWER's. The linker's --wrap leads
// sysconf() and madvise() here.
#include "core/base/memory/large_pages.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace {

constexpr long page = 65536;
uintptr_t asked_at = 0;
size_t asked_bytes = 0;

} // namespace

extern "C" {
long __real_sysconf(int name);
long __wrap_sysconf(int name);
int __wrap_madvise(void* at, size_t bytes, int advice);

long __wrap_sysconf(int name) {
    return name == _SC_PAGESIZE ? page : __real_sysconf(name);
}

int __wrap_madvise(void* at, size_t bytes, int) {
    asked_at = reinterpret_cast<uintptr_t>(at);
    asked_bytes = bytes;
    return 0;
}
}

namespace {

TEST(LargePages, OnlyPagesThatLieWithinAreAskedFor) {
#ifdef MADV_HUGEPAGE
    const std::vector<char> memory(size_t(6) << 20);
    const auto begin = reinterpret_cast<uintptr_t>(memory.data()) + 5000;
    const size_t bytes = memory.size() - 9000;
    ddt::ask_for_large_pages(reinterpret_cast<void*>(begin), bytes);
    EXPECT_EQ(asked_at % page, 0u);
    EXPECT_EQ(asked_bytes % page, 0u);
    EXPECT_GE(asked_at, begin);
    EXPECT_LT(asked_at, begin + page);
    EXPECT_LE(asked_at + asked_bytes, begin + bytes);
    EXPECT_GT(asked_at + asked_bytes + page, begin + bytes);

    asked_bytes = 0;
    ddt::ask_for_large_pages(memory.data(), 4096);
    ddt::ask_for_large_pages(nullptr, memory.size());
    EXPECT_EQ(asked_bytes, 0u);
#endif
}

} // namespace
