// SPDX-License-Identifier: Apache-2.0
// Errors of the functions of ddt/points.h.
#pragma once

#include <new>
#include <string>

namespace ddt {

/// Call f(why), which returns whether it succeeded; no exception leaves, and `error` receives one
/// line, or none on success.
template <class F>
bool guarded_call(std::string* error, F&& f) {
    std::string why;
    bool done = false;
    try {
        done = f(why);
    } catch (const std::bad_alloc&) {
        why = "ddt: out of memory";
    }
    if (error)
        *error = done ? "" : why;
    return done;
}

} // namespace ddt
