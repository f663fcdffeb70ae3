// SPDX-License-Identifier: Apache-2.0
// A system that does not let pages be made writable, while `refuse` is set: the program's
// mprotect() goes before the C library's. To be included once in a program.
#pragma once

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

#include "tests/plugin/register/answer.h"

namespace {

bool refuse = false;

} // namespace

extern "C" DDT_TEST_EXPORT int mprotect(void* address, size_t size, int protection) noexcept {
    if (refuse && (protection & PROT_WRITE)) {
        errno = EACCES;
        return -1;
    }
    return int(syscall(SYS_mprotect, address, size, protection));
}
