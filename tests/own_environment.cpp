// SPDX-License-Identifier: Apache-2.0
// Linked into programs whose results would be others in the environment of whoever runs them: a
// facility's colour configuration, a choice of GPU. DDT_DEVICE is left: of most programs tests are
// the CPU's (ddt_program_test in CMakeLists.txt); ./check has it unset for those of GPUs.
#include <cstdlib>
#include <initializer_list>

namespace {

[[maybe_unused]] const bool is_own = [] {
    for (const char* name : {"OCIO", "DDT_EGL_DEVICE", "DDT_VERBOSE", "OPENIMAGEIO_OPTIONS"})
        unsetenv(name);
    return true;
}();

} // namespace
