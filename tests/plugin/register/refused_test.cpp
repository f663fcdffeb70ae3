// SPDX-License-Identifier: Apache-2.0
// A system that does not let pages be made writable. This program's mprotect() goes before the C
// library's.
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include <gtest/gtest.h>

#include "answer.h"
#include "got.h"

namespace {

bool refuse = false;

int replacement() {
    return 43;
}

} // namespace

extern "C" DDT_TEST_EXPORT int mprotect(void* address, size_t size, int protection) noexcept {
    if (refuse && (protection & PROT_WRITE)) {
        errno = EACCES;
        return -1;
    }
    return int(syscall(SYS_mprotect, address, size, protection));
}

namespace {

TEST(Refused, WhatCannotBeWrittenIsCountedAndStays) {
    const ddt::got::Redirect redirect = {"answer", reinterpret_cast<void*>(&answer),
                                         reinterpret_cast<void*>(&replacement)};
    refuse = true;
    const ddt::got::Report report = ddt::got::redirect(&redirect, 1);
    refuse = false;
    EXPECT_EQ(report.slots, 0);
    EXPECT_EQ(report.exports, 0);
    EXPECT_EQ(report.refused, 3); // the symbol, and in read-only data the own call's and a pointer
    EXPECT_EQ(answer_from_within(), 42);
    EXPECT_EQ(answer_by_pointer(), 42);
}

} // namespace
