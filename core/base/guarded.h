// SPDX-License-Identifier: Apache-2.0
// The boundary of the library: no exception passes it, and within it floats are as DefaultFloats
// has them.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "core/base/float_mode.h"
#include "core/base/one_line.h"

namespace ddt {

/// What came out of a guarded call.
enum class Caught { nothing, out_of_memory, other };

/// Set *error, unless null, to "ddt: " and `what` in one line; to nothing where memory runs out.
inline void set_error(std::string* error, const char* what) noexcept {
    if (!error)
        return;
    error->clear();
    try {
        *error = with_prefix(one_line(what));
    } catch (...) {
    }
}

/// Call f(). What it throws, of whatever type, ends here as one line in *error.
template <class F>
Caught guarded_call(std::string* error, F&& f) noexcept {
    const DefaultFloats always;
    try {
        f();
        return Caught::nothing;
    } catch (const std::bad_alloc&) {
        set_error(error, out_of_memory_text);
        return Caught::out_of_memory;
    } catch (const std::length_error&) { // of a size that no vector can have
        set_error(error, out_of_memory_text);
        return Caught::out_of_memory;
    } catch (const std::exception& e) {
        set_error(error, e.what());
    } catch (...) {
        set_error(error, "an exception of unknown type");
    }
    return Caught::other;
}

/// Call f(why), which returns whether it succeeded. *error receives one line, or none on success.
template <class F>
bool succeeds(std::string* error, F&& f) noexcept {
    bool done = false;
    const Caught caught = guarded_call(error, [&] {
        std::string why;
        done = f(why);
        if (error)
            *error = done ? std::string() : one_line(why);
    });
    return done && caught == Caught::nothing;
}

} // namespace ddt
