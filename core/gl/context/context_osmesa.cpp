// SPDX-License-Identifier: Apache-2.0
// Mesa's off-screen interface (GL/osmesa.h), in which Mesa rendered to memory until version 25.1.
#include "core/gl/context/context.h"
#include "core/gl/context/faults.h"
#include "core/gl/context/library.h"

namespace ddt::gl {

namespace {

// From Mesa's GL/osmesa.h, so that it need not be there to build.
constexpr int osmesa_format = 0x22, osmesa_profile = 0x33, osmesa_core_profile = 0x34,
              osmesa_major_version = 0x36, osmesa_minor_version = 0x37;

using CreateContextAttribs = void* (*)(const int* attributes, void* share);
using MakeCurrent = GLboolean (*)(void* context, void* buffer, GLenum type, GLsizei width,
                                  GLsizei height);
using GetProcAddress = void* (*)(const char* name);

} // namespace

std::unique_ptr<Context> make_osmesa_context(std::string& why) {
    const Library library({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
    if (!library.open()) {
        why = library.error();
        return nullptr;
    }
    CreateContextAttribs create;
    MakeCurrent make_current;
    static GetProcAddress get_address;
    if (!library.find("OSMesaCreateContextAttribs", create) ||
        !library.find("OSMesaMakeCurrent", make_current) ||
        !library.find("OSMesaGetProcAddress", get_address)) {
        why = "libOSMesa has no OSMesaCreateContextAttribs (Mesa 11.2 or later is needed)";
        return nullptr;
    }
    const int attributes[] = {osmesa_format,
                              GL_RGBA,
                              osmesa_profile,
                              osmesa_core_profile,
                              osmesa_major_version,
                              4,
                              osmesa_minor_version,
                              3,
                              0};
    void* handle = strikes(Fault::context) ? nullptr : create(attributes, nullptr);
    if (!handle) {
        why = "OSMesaCreateContextAttribs gave no OpenGL 4.3 core context";
        return nullptr;
    }
    auto* pixel = new unsigned char[4]; // a context wants some buffer; nothing is drawn in it
    if (!make_current(handle, pixel, GL_UNSIGNED_BYTE, 1, 1)) {
        why = "OSMesaMakeCurrent failed";
        return nullptr;
    }
    auto context = std::make_unique<Context>();
    context->platform = "OSMesa";
    const Lookup lookup = [](const void*, const char* name) { return get_address(name); };
    if (!describe_current(nullptr, lookup, *context, why))
        return nullptr;
    context->software = true;
    return context;
}

} // namespace ddt::gl
