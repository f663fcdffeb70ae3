// SPDX-License-Identifier: Apache-2.0
// Stands in for context_egl.cpp where EGL's headers were missing when this was built.
#include "core/gl/context/context.h"

namespace ddt::gl {

std::unique_ptr<Context> make_egl_context(Wanted, std::string& why) {
    why = "built without EGL's headers";
    return nullptr;
}

} // namespace ddt::gl
