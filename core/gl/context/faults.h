// SPDX-License-Identifier: Apache-2.0
// Failures made to happen, for tests of what follows them: their copy of core/gl is built with
// DDT_FAULTS. In the library nothing ever strikes. Not thread-safe against running jobs.
#pragma once

#include <string>

namespace ddt::gl {

enum class Fault {
    library,    ///< a GL library cannot be loaded
    context,    ///< a context is refused
    shader,     ///< a shader does not compile
    allocation, ///< a buffer cannot be allocated
    lost,       ///< the context is lost at a point where that is looked for
    count
};

#ifndef DDT_FAULTS

constexpr bool strikes(Fault) {
    return false;
}

#else

/// Let the fault strike at the n-th chance from now (1: the next) and at `times` in a row.
/// n = 0: never.
void arm(Fault fault, int n, int times = 1);

/// Called where the fault could strike; true if it is to.
bool strikes(Fault fault);

/// Chances the fault has had since it was armed.
int chances(Fault fault);

/// Let one program (Programs::use(), its file and macros with a space between) have another value
/// for a constant of core/base/constants.h, or for a macro with one; an empty program: none. Of
/// programs compiled from now on.
void change_constant(const std::string& program, const std::string& name, const std::string& value);
/// The same of any text that stands in the program: each is replaced.
void change_text(const std::string& program, const std::string& before, const std::string& after);
/// Whether a program was compiled that the change was asked for.
bool was_changed();
/// The source with what was changed of the program.
std::string with_change(const std::string& program, std::string source);

/// Where hardware's device files are, in place of /dev.
void look_for_hardware_in(const std::string& folder);

/// Forget the devices opened so far, so that the next job opens them anew.
void forget_devices();

#endif

} // namespace ddt::gl
