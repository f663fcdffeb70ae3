// SPDX-License-Identifier: Apache-2.0
// Redirecting functions of shared libraries within the running process.
#pragma once

#include <cstddef>

namespace ddt::got {

/// Calls of `from`, a function that a shared library exports, shall reach `to`.
struct Redirect {
    const char* label; ///< for messages
    void* from;
    void* to;
};

/// What redirect() changed, and what it could not.
struct Report {
    int slots = 0; ///< entries of global offset tables and stored pointers
    int own_slots =
        0;           ///< those of them in the libraries that define the functions: their own calls
    int exports = 0; ///< entries of symbol tables
    int refused = 0; ///< entries that the system did not let be written
    int missed = 0;  ///< functions that no library exports, or that are redirected already
    int others = 0;  ///< libraries with functions of the same names that are not redirected
    const char* last_missed = nullptr; ///< label of the last of the functions missed
    const char* other = nullptr;       ///< path of the last such library, while it is loaded
};

/// Redirect `count` functions in every module that is loaded now and, by the symbol table of the
/// library that defines the function, in every module loaded later and in calls not bound yet. The
/// module that `to` lies in is left alone, so there `from` still means the function itself; it must
/// be linked with `-z now` and never be unloaded. A pointer that somebody else has redirected
/// already is left alone too. A library linked with -Bsymbolic-functions has no entries for calls
/// of its own functions: what it exports is redirected, what it calls itself is not. Call it while
/// no other thread loads modules: from a constructor, for example. Does nothing on systems other
/// than ELF on x86-64 and AArch64. Never throws.
Report redirect(const Redirect* redirects, size_t count) noexcept;

} // namespace ddt::got
