// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/functions.h"

namespace ddt::gl {

std::string load_functions(const void* library, Lookup lookup, Functions& gl) {
#define DDT_LOAD(TYPE, NAME)                                                                       \
    gl.NAME = reinterpret_cast<PFNGL##TYPE##PROC>(lookup(library, "gl" #NAME));                    \
    if (!gl.NAME)                                                                                  \
        return "gl" #NAME;
    DDT_GL_FUNCTIONS(DDT_LOAD)
#undef DDT_LOAD
    return {};
}

std::string error_name(GLenum error) {
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
        return "GL_CONTEXT_LOST";
    default:
        return "GL error " + std::to_string(error);
    }
}

} // namespace ddt::gl
