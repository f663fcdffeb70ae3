// SPDX-License-Identifier: Apache-2.0
// OpenGL contexts without a display.
#pragma once

#include <memory>
#include <string>

#include "core/gl/context/functions.h"

namespace ddt::gl {

/// A current context and its functions. It belongs to the thread that made it, stays current there,
/// and is never destroyed: drivers may be gone, or in use by the host, when a process ends.
struct Context {
    Functions gl;
    std::string platform;  ///< how it was had: "EGL device 0"
    std::string renderer;  ///< GL_RENDERER
    std::string version;   ///< GL_VERSION
    bool software = false; ///< llvmpipe and its like: native code is faster
    bool tested = false;   ///< a renderer that the project's own tests run on
    /// A dispatch's loops may end after 65535 turns, as llvmpipe's do.
    bool short_loops = false;
};

/// Which renderers will do.
enum class Wanted { any, hardware };

/// An OpenGL 4.3 core context through libEGL: on a hardware device, else on Mesa's surfaceless
/// platform, the default display, a software device. Makes it current on this thread. Null if
/// there is none; `why` then says which call failed.
std::unique_ptr<Context> make_egl_context(Wanted wanted, std::string& why);

/// The same through libOSMesa, always software.
std::unique_ptr<Context> make_osmesa_context(std::string& why);

/// Whether a renderer of this name (GL_RENDERER) is none of hardware.
bool is_software(const std::string& renderer);
/// Whether it draws by a host's renderer, of which the name tells little or nothing: it may be of
/// software.
bool is_guest(const std::string& renderer);
/// Whether it is one that the project's own tests run on, and not by way of another API.
bool is_tested(const std::string& renderer);
/// Mesa's OpenGL by way of Vulkan. In what stays mapped its copies may be missing when the fence is
/// signalled (22.3); over lavapipe it computes with uniforms of the dispatch before.
bool is_zink(const std::string& renderer);

/// Load the functions of the context that is current, and learn what it is. False with `why` if it
/// is not OpenGL 4.3, lacks one of its functions, or is known to compute otherwise (a software
/// renderer by way of zink).
bool describe_current(const void* library, Lookup lookup, Context& context, std::string& why);

} // namespace ddt::gl
