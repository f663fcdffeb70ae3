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

/// What redirect() changed.
struct Report {
    int slots = 0;                ///< entries of global offset tables and stored pointers
    int exports = 0;              ///< entries of symbol tables
    const char* missed = nullptr; ///< label of the last function that could not be redirected
};

/// Redirect `count` functions in every module that is loaded now and, by the symbol table of the
/// library that defines the function, in every module loaded later. The module that `to` lies in
/// is left alone, so there `from` still means the function itself; it must be linked with
/// `-z now` and never be unloaded. A pointer that somebody else has redirected already is left
/// alone too. Call it while no other thread loads modules: from a constructor, for example.
/// Does nothing on systems other than ELF on x86-64 and AArch64. Never throws.
Report redirect(const Redirect* redirects, size_t count) noexcept;

} // namespace ddt::got
