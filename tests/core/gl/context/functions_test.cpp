// SPDX-License-Identifier: Apache-2.0
// Which functions are taken of drivers whose lookups find every name.
#include "core/gl/context/functions.h"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/gl/context/context.h"

namespace ddt::test {
namespace {

/// A context of OpenGL 4.`minor` with these extensions.
struct Driver {
    GLint minor;
    std::vector<const char*> extensions;
} g_driver;

const GLubyte* APIENTRY get_string(GLenum) {
    return reinterpret_cast<const GLubyte*>("a driver");
}
const GLubyte* APIENTRY get_string_i(GLenum, GLuint i) {
    return reinterpret_cast<const GLubyte*>(g_driver.extensions.at(i));
}
void APIENTRY get_integer(GLenum what, GLint* value) {
    *value = what == GL_MAJOR_VERSION   ? 4
             : what == GL_MINOR_VERSION ? g_driver.minor
                                        : GLint(g_driver.extensions.size());
}
GLenum APIENTRY core() {
    return 1;
}
GLenum APIENTRY khr() {
    return 2;
}
GLenum APIENTRY arb() {
    return 3;
}

void* find(const void*, const char* name) {
    const auto is = [&](const char* other) { return std::strcmp(name, other) == 0; };
    return is("glGetString")                   ? reinterpret_cast<void*>(get_string)
           : is("glGetStringi")                ? reinterpret_cast<void*>(get_string_i)
           : is("glGetIntegerv")               ? reinterpret_cast<void*>(get_integer)
           : is("glGetGraphicsResetStatusKHR") ? reinterpret_cast<void*>(khr)
           : is("glGetGraphicsResetStatusARB") ? reinterpret_cast<void*>(arb)
                                               : reinterpret_cast<void*>(core);
}
void* find_suffixed(const void* library, const char* name) {
    return std::strcmp(name, "glGetGraphicsResetStatus") == 0 ? nullptr : find(library, name);
}

gl::Functions functions_of(const Driver& driver, gl::Lookup lookup = find) {
    g_driver = driver;
    gl::Context context;
    std::string why;
    EXPECT_TRUE(gl::describe_current(nullptr, lookup, context, why)) << why;
    return context.gl;
}

/// 0: it is not called.
GLenum reset_status(const gl::Functions& gl) {
    return gl.GetGraphicsResetStatus ? gl.GetGraphicsResetStatus() : 0;
}

TEST(Functions, ThatTheContextDoesNotHaveAreNotCalled) {
    EXPECT_EQ(reset_status(functions_of({3, {}})), 0u);
    EXPECT_EQ(reset_status(functions_of({4, {"GL_KHR_robust_buffer_access_behavior"}})), 0u);
    EXPECT_EQ(reset_status(functions_of({4, {"GL_KHR_debug", "GL_KHR_robustness"}})), 1u);
    EXPECT_EQ(reset_status(functions_of({4, {"GL_KHR_robustness"}}, find_suffixed)), 2u);
    EXPECT_EQ(reset_status(functions_of({3, {"GL_ARB_robustness"}})), 3u);
    EXPECT_EQ(reset_status(functions_of({5, {}})), 1u);
    EXPECT_EQ(reset_status(functions_of({5, {}}, find_suffixed)), 0u);
    EXPECT_EQ(functions_of({3, {}}).BufferStorage, nullptr);
    EXPECT_NE(functions_of({4, {}}).BufferStorage, nullptr);
}

} // namespace
} // namespace ddt::test
