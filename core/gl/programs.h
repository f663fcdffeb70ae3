// SPDX-License-Identifier: Apache-2.0
// Compute programs from the embedded shaders.
#pragma once

#include <map>
#include <string>

#include "core/gl/context/functions.h"
#include "ddt/options.h"

namespace ddt::gl {

/// Tiles that one dispatch can hold.
constexpr int max_tiles = 64;
/// Invocations of the group that does a tile's late iterations.
constexpr int finish_group = 512;

/// The programs compiled so far. To be used on the context's thread.
class Programs {
public:
    explicit Programs(const Functions& gl) : m_gl(gl) {}

    /// Use the program of shader `file` with the macros named in `defines` (separated by spaces),
    /// compiling it at the first use. Throws Failure with the compiler's messages.
    void use(const std::string& file, const std::string& defines = "");

    /// How often each shader was used, whatever its macros: nearly all uses are one dispatch.
    const std::map<std::string, int>& uses() const { return m_uses; }
    int compiled() const { return int(m_programs.size()); }
    double milliseconds() const { return m_milliseconds; }

private:
    GLuint compile(const std::string& file, const std::string& defines);

    const Functions& m_gl;
    std::map<std::string, GLuint> m_programs;
    std::map<std::string, int> m_uses;
    double m_milliseconds = 0; ///< spent compiling
};

/// The text given to the compiler: version, macros, and the file with its includes, each once.
std::string shader_source(const std::string& file, const std::string& defines);

} // namespace ddt::gl
