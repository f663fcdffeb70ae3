// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/context.h"

#include <climits>
#include <cstring>
#include <type_traits>

namespace ddt::gl {

namespace {

std::string text(const Functions& gl, GLenum what) {
    const GLubyte* s = gl.GetString(what);
    return s ? reinterpret_cast<const char*>(s) : "unknown";
}

bool has_extension(const Functions& gl, const char* name) {
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* s = gl.GetStringi(GL_EXTENSIONS, GLuint(i));
        if (s && std::strcmp(reinterpret_cast<const char*>(s), name) == 0)
            return true;
    }
    return false;
}

/// Load what OpenGL 4.`minor` has beyond 4.3 or an extension adds. Lookups find names of what a
/// driver does not have; called all the same, those record errors, of which others would be told.
void load_later_functions(const void* library, Lookup lookup, int minor, Functions& gl) {
    const auto find = [&](auto& function, const char* name) {
        if (!function)
            function = reinterpret_cast<std::decay_t<decltype(function)>>(lookup(library, name));
    };
    if (minor >= 4)
        find(gl.BufferStorage, "glBufferStorage");
    const bool khr = has_extension(gl, "GL_KHR_robustness");
    if (minor >= 5 || khr)
        find(gl.GetGraphicsResetStatus, "glGetGraphicsResetStatus");
    if (khr)
        find(gl.GetGraphicsResetStatus, "glGetGraphicsResetStatusKHR");
    if (has_extension(gl, "GL_ARB_robustness"))
        find(gl.GetGraphicsResetStatus, "glGetGraphicsResetStatusARB");
}

} // namespace

bool is_software(const std::string& renderer) {
    // The last is Direct3D's own, by way of Mesa's d3d12. In any case: virgl writes LLVMPIPE.
    for (const char* name :
         {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer", "Microsoft Basic Render"})
        if (strcasestr(renderer.c_str(), name))
            return true;
    return false;
}

bool is_guest(const std::string& renderer) {
    return renderer.rfind("virgl", 0) == 0 || renderer.rfind("SVGA3D", 0) == 0;
}

bool is_tested(const std::string& renderer) {
    return renderer.rfind("llvmpipe", 0) == 0;
}

bool is_zink(const std::string& renderer) {
    return renderer.find("zink") != std::string::npos; // virgl's host may have it
}

bool describe_current(const void* library, Lookup lookup, Context& context, std::string& why) {
    Functions& gl = context.gl;
    const std::string missing = load_functions(library, lookup, gl);
    if (gl.GetString) {
        context.renderer = text(gl, GL_RENDERER);
        context.version = text(gl, GL_VERSION);
    }
    GLint major = 0, minor = 0;
    if (gl.GetIntegerv) {
        gl.GetIntegerv(GL_MAJOR_VERSION, &major);
        gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    }
    if (major < 4 || (major == 4 && minor < 3)) {
        why = "OpenGL 4.3 is needed, " + context.renderer + " has " + context.version;
        return false;
    }
    if (!missing.empty()) {
        why = context.renderer + " lacks " + missing;
        return false;
    }
    if (is_zink(context.renderer) && is_software(context.renderer)) {
        why =
            context.renderer +
            " is a software renderer by way of Vulkan, which loses contexts or computes otherwise";
        return false;
    }
    load_later_functions(library, lookup, major > 4 ? INT_MAX : minor, gl);
    if (is_zink(context.renderer))
        gl.BufferStorage = nullptr;
    context.software = is_software(context.renderer);
    context.tested = is_tested(context.renderer);
    context.short_loops = context.software || is_guest(context.renderer);
    return true;
}

} // namespace ddt::gl
