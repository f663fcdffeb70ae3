// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/library.h"

#include <dlfcn.h>

#include "core/gl/context/faults.h"

namespace ddt::gl {

Library::Library(std::initializer_list<const char*> names) {
    const bool missing = strikes(Fault::library);
    for (const char* name : names) {
        if (!missing)
            m_handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (m_handle)
            return;
        if (m_error.empty()) {
            const char* why = missing ? nullptr : dlerror();
            m_error = why ? why : std::string(name) + ": not found";
        }
    }
}

void* Library::find(const char* symbol) const {
    return m_handle ? dlsym(m_handle, symbol) : nullptr;
}

} // namespace ddt::gl
