// SPDX-License-Identifier: Apache-2.0
// EGL without a window system. The display may be one the host uses too, so it is never terminated.
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "core/gl/context/context.h"
#include "core/gl/context/faults.h"
#include "core/gl/context/hardware.h"
#include "core/gl/context/library.h"

namespace ddt::gl {

namespace {

struct Egl {
    PFNEGLGETPROCADDRESSPROC GetProcAddress = nullptr;
    PFNEGLQUERYSTRINGPROC QueryString = nullptr;
    PFNEGLGETDISPLAYPROC GetDisplay = nullptr;
    PFNEGLINITIALIZEPROC Initialize = nullptr;
    PFNEGLBINDAPIPROC BindAPI = nullptr;
    PFNEGLCREATECONTEXTPROC CreateContext = nullptr;
    PFNEGLDESTROYCONTEXTPROC DestroyContext = nullptr;
    PFNEGLMAKECURRENTPROC MakeCurrent = nullptr;
    PFNEGLGETERRORPROC GetError = nullptr;
    // Extensions; null where there are none.
    PFNEGLQUERYDEVICESEXTPROC QueryDevices = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay = nullptr;
    bool surfaceless = false;

    bool load(std::string& why) {
        const Library library({"libEGL.so.1", "libEGL.so"});
        if (!library.open()) {
            why = library.error();
            return false;
        }
        if (!library.find("eglGetProcAddress", GetProcAddress) ||
            !library.find("eglQueryString", QueryString) ||
            !library.find("eglGetDisplay", GetDisplay) ||
            !library.find("eglInitialize", Initialize) || !library.find("eglBindAPI", BindAPI) ||
            !library.find("eglCreateContext", CreateContext) ||
            !library.find("eglDestroyContext", DestroyContext) ||
            !library.find("eglMakeCurrent", MakeCurrent) ||
            !library.find("eglGetError", GetError)) {
            why = "libEGL is not EGL 1.4";
            return false;
        }
        const char* extensions = QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
        const std::string names = extensions ? extensions : "";
        const auto has = [&](const char* name) { return names.find(name) != std::string::npos; };
        if (has("EGL_EXT_platform_base"))
            GetPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
                GetProcAddress("eglGetPlatformDisplayEXT"));
        if (has("EGL_EXT_platform_device") || has("EGL_EXT_device_base") ||
            has("EGL_EXT_device_enumeration")) {
            QueryDevices =
                reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(GetProcAddress("eglQueryDevicesEXT"));
            QueryDeviceString = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
                GetProcAddress("eglQueryDeviceStringEXT"));
        }
        surfaceless = GetPlatformDisplay && has("EGL_MESA_platform_surfaceless");
        return true;
    }
};

std::string egl_error(const Egl& egl) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%04X", unsigned(egl.GetError()));
    return text;
}

/// A way to a display.
struct Candidate {
    std::string platform;
    EGLenum kind; ///< 0: the default display
    void* native;
};

/// What names one of a machine's GPUs, by its number among them as EGL lists them.
constexpr const char* gpu_variable = "DDT_EGL_DEVICE";

/// Of all the named one alone.
std::vector<Candidate> only(const char* name, const std::vector<Candidate>& gpus,
                            std::string& why) {
    size_t number = gpus.size();
    const char* end = name + std::strlen(name);
    if (const auto parsed = std::from_chars(name, end, number);
        parsed.ec == std::errc() && parsed.ptr == end && number < gpus.size())
        return {gpus[number]};
    why = std::string(gpu_variable) + "=" + name + " is none of the " +
          std::to_string(gpus.size()) + " GPUs that EGL lists, counted from 0";
    return {};
}

/// All ways, in the order in which they are tried; `why` if there is none.
std::vector<Candidate> candidates(const Egl& egl, Wanted wanted, std::string& why) {
    std::vector<Candidate> hardware, software;
    EGLDeviceEXT devices[32];
    EGLint n = 0;
    const bool known =
        egl.QueryDevices && egl.GetPlatformDisplay && egl.QueryDevices(32, devices, &n);
    for (int i = 0; known && i < n; ++i) {
        const char* extensions =
            egl.QueryDeviceString ? egl.QueryDeviceString(devices[i], EGL_EXTENSIONS) : nullptr;
        const bool soft = extensions && std::strstr(extensions, "EGL_MESA_device_software");
        (soft ? software : hardware)
            .push_back({"EGL device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, devices[i]});
    }
    why = "EGL lists no hardware device";
    if (const char* name = std::getenv(gpu_variable); name && *name)
        return only(name, hardware, why);
    std::vector<Candidate> all = hardware;
    // The list could be read: no hardware in it means there is none.
    if (wanted == Wanted::hardware && known && !hardware_unlisted())
        return all;
    if (egl.surfaceless)
        all.push_back({"EGL surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    all.push_back({"EGL default display", 0, nullptr});
    all.insert(all.end(), software.begin(), software.end());
    return all;
}

/// Of an OpenGL 4.`minor` core context; `robust`: one that says when it is lost.
std::vector<EGLint> context_attributes(EGLint minor, bool robust) {
    std::vector<EGLint> all = {
        EGL_CONTEXT_MAJOR_VERSION_KHR,       4,
        EGL_CONTEXT_MINOR_VERSION_KHR,       minor,
        EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR};
    if (robust)
        all.insert(all.end(), {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR,
                               EGL_LOSE_CONTEXT_ON_RESET_KHR});
    all.push_back(EGL_NONE);
    return all;
}

/// Make a context on the candidate's display and make it current.
std::unique_ptr<Context> try_candidate(const Egl& egl, const Candidate& candidate, Wanted wanted,
                                       std::string& why) {
    const auto failed = [&](const char* call) {
        why = candidate.platform + ": " + call + " failed with " + egl_error(egl);
        return nullptr;
    };
    const EGLDisplay display =
        candidate.kind ? egl.GetPlatformDisplay(candidate.kind, candidate.native, nullptr)
                       : egl.GetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY)
        return failed("eglGetPlatformDisplay");
    EGLint major = 0, minor = 0;
    if (!egl.Initialize(display, &major, &minor))
        return failed("eglInitialize");
    const char* extensions = egl.QueryString(display, EGL_EXTENSIONS);
    const auto has = [&](const char* name) {
        return extensions && std::strstr(extensions, name) != nullptr;
    };
    if (!has("EGL_KHR_surfaceless_context") || !has("EGL_KHR_create_context")) {
        why = candidate.platform + ": EGL " + std::to_string(major) + "." + std::to_string(minor) +
              " without EGL_KHR_surfaceless_context and EGL_KHR_create_context";
        return nullptr;
    }
    if (!egl.BindAPI(EGL_OPENGL_API))
        return failed("eglBindAPI(EGL_OPENGL_API)");
    EGLContext handle = EGL_NO_CONTEXT;
    const bool refused = strikes(Fault::context);
    // 4.4 has host memory that stays mapped; some drivers give what is asked for and no more. Of
    // each a context that says when it is lost, else one that does not.
    for (const EGLint of_four : {4, 3})
        for (const bool robust : {true, false})
            if (handle == EGL_NO_CONTEXT && !refused)
                handle = egl.CreateContext(display, EGLConfig(nullptr), EGL_NO_CONTEXT,
                                           context_attributes(of_four, robust).data());
    if (handle == EGL_NO_CONTEXT)
        return failed("eglCreateContext(OpenGL 4.3 core)");
    auto context = std::make_unique<Context>();
    context->platform = candidate.platform;
    if (!egl.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle)) {
        failed("eglMakeCurrent");
        egl.DestroyContext(display, handle);
        return nullptr;
    }
    const Lookup lookup = [](const void* library, const char* name) {
        return reinterpret_cast<void*>(static_cast<const Egl*>(library)->GetProcAddress(name));
    };
    bool fits = describe_current(&egl, lookup, *context, why);
    if (fits && wanted == Wanted::hardware && context->software) {
        why = candidate.platform + ": " + context->renderer + " is a software renderer";
        fits = false;
    }
    if (!fits) {
        egl.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl.DestroyContext(display, handle);
        return nullptr;
    }
    return context;
}

} // namespace

std::unique_ptr<Context> make_egl_context(Wanted wanted, std::string& why) {
    Egl egl;
    if (!egl.load(why))
        return nullptr;
    std::string none, reasons;
    for (const Candidate& candidate : candidates(egl, wanted, none)) {
        if (auto context = try_candidate(egl, candidate, wanted, why))
            return context;
        reasons += (reasons.empty() ? "" : "; ") + why;
    }
    why = reasons.empty() ? none : reasons;
    return nullptr;
}

} // namespace ddt::gl
