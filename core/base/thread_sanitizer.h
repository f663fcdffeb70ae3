// SPDX-License-Identifier: Apache-2.0
// What a library orders between threads, told to the thread sanitizer: it sees the synchronisation
// of code compiled with it alone, and oneTBB's is not. Without the sanitizer nothing is compiled.
#pragma once

#ifdef DDT_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace ddt {

/// Whatever comes after this with a `token` comes after all that came before happens_before() with
/// the same one.
inline void happens_after([[maybe_unused]] void* token) {
#ifdef DDT_THREAD_SANITIZER
    __tsan_acquire(token);
#endif
}

inline void happens_before([[maybe_unused]] void* token) {
#ifdef DDT_THREAD_SANITIZER
    __tsan_release(token);
#endif
}

} // namespace ddt
