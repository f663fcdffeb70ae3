// SPDX-License-Identifier: Apache-2.0
// Work shared among threads.
//
// Two files make these functions, and a program links one of them: parallel_tbb.cpp, by oneTBB's
// pool, is part of ddt_core where oneTBB was found; parallel_std.cpp, by threads that live no
// longer than the call, is for builds without it, and for modules that a foreign program loads:
// that program may bring a oneTBB of its own, and may unload the module.
#pragma once

#include <functional>

namespace ddt {

/// How many threads to use where nobody says: the processors that the process may run on, or fewer
/// where a container's quota (control_groups.h) or oneTBB's own limit says so.
int usual_threads();

/// The number to use where `wanted` are asked for: never more than oneTBB's limit, which it would
/// print a warning about; at least 1.
int allowed_threads(int wanted);

/// The number to use for an option: `wanted` if more than 0, else the usual one.
inline int threads_for(int wanted) {
    return wanted > 0 ? allowed_threads(wanted) : usual_threads();
}

/// Let allowed_threads() allow this many from now on, where oneTBB's limit is lower, as on fewer
/// cores: for programs of our own, whose user asked for them. Libraries leave the limit alone.
void allow_threads(int number);

/// Call `body(slot, index)` for every index from 0 to `count` - 1, on up to `threads` threads, the
/// caller among them; return when all is done. Two calls at the same time have different slots,
/// which are from 0 to `threads` - 1; with `threads` 1 the calls come in ascending order. An
/// exception from `body` keeps further indices from being begun and comes out here.
void for_each_index(int threads, int count, const std::function<void(int slot, int index)>& body);

} // namespace ddt
