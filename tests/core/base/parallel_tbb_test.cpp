// SPDX-License-Identifier: Apache-2.0
// What oneTBB makes of a process that has no memory left.
#include <cstdio>
#include <exception>
#include <new>

#include <sys/resource.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "tests/resource_limit.h"

namespace {

/// Bytes of address space that the process has taken.
rlim_t address_space() {
    unsigned long pages = 0;
    std::FILE* const file = std::fopen("/proc/self/statm", "r");
    if (file) {
        EXPECT_EQ(std::fscanf(file, "%lu", &pages), 1);
        std::fclose(file);
    }
    return rlim_t(pages) * rlim_t(sysconf(_SC_PAGESIZE));
}

enum Outcome { done = 10, no_memory, other };

/// With so much address space more than there is, in a process of its own that has not used oneTBB.
void share_work_within(rlim_t bytes) {
    const ddt::test::ResourceLimit limit(RLIMIT_AS, address_space() + bytes);
    alarm(20);
    Outcome outcome = done;
    try {
        ddt::for_each_index(4, 100, [](int, int) {});
    } catch (const std::bad_alloc&) {
        outcome = no_memory;
    } catch (const std::exception&) {
        outcome = other;
    }
    _exit(outcome);
}

// oneTBB 2022 waits for itself where less than 1 MiB is left; 2021 says that it has no thread.
TEST(ParallelTbb, WithoutMemoryForAThreadSaysSo) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const rlim_t kibibytes : {0, 64, 256, 512, 1024, 4096, 8000})
        EXPECT_EXIT(share_work_within(kibibytes << 10), testing::ExitedWithCode(no_memory), "")
            << kibibytes;
    EXPECT_EXIT(share_work_within(rlim_t(1) << 30), testing::ExitedWithCode(done), "");
}

} // namespace
