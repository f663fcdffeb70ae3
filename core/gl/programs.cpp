// SPDX-License-Identifier: Apache-2.0
#include "core/gl/programs.h"

#include <chrono>
#include <cstring>
#include <set>
#include <sstream>

#include "core/base/constants.h"
#include "core/gl/context/failure.h"
#include "core/gl/context/faults.h"
#include "core/gl/shader_text.h"

namespace ddt::gl {

namespace {

const char* text_of(const std::string& file) {
    for (const ShaderText* t = shader_texts; t->name; ++t)
        if (file == t->name)
            return t->text;
    throw Failure("no shader is named " + file);
}

/// Append the file, each #include "name" replaced by that file's text at its first mention.
void append(const std::string& file, std::set<std::string>& included, std::string& out) {
    static const std::string include = "#include \"";
    std::istringstream lines(text_of(file));
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, include.size(), include) != 0) {
            out += line + '\n';
            continue;
        }
        const std::string name = line.substr(include.size(), line.rfind('"') - include.size());
        if (included.insert(name).second)
            append(name, included, out);
    }
}

std::string define(const char* name, const std::string& value) {
    return std::string("#define ") + name + ' ' + value + '\n';
}

/// The constants of core/base/constants.h, floats by their bits.
std::string constants() {
    std::ostringstream out;
    const auto put = [&](const char* name, float value) {
        uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        out << "const float " << name << " = uintBitsToFloat(" << bits << "u); // " << value
            << '\n';
    };
#define DDT_INT(name, value) out << "const int " #name " = " << name << ";\n";
#define DDT_FLOAT(name, value) put(#name, name);
    DDT_CONSTANTS(DDT_INT, DDT_FLOAT)
#undef DDT_INT
#undef DDT_FLOAT
    return out.str();
}

} // namespace

std::string shader_source(const std::string& file, const std::string& defines) {
    std::string out = "#version 430 core\n";
#define DDT_LAYOUT(NAME, name, value) out += define(#NAME, std::to_string(name));
    DDT_LAYOUTS(DDT_LAYOUT)
#undef DDT_LAYOUT
    std::istringstream names(defines);
    for (std::string name; names >> name;)
        out += define(name.c_str(), "");
    out += constants();
    std::set<std::string> included;
    append(file, included, out);
    return out;
}

void Programs::use(const std::string& file, const std::string& defines) {
    GLuint& program = m_programs[file + ' ' + defines];
    if (!program) {
        const auto begin = std::chrono::steady_clock::now();
        program = compile(file, defines);
        m_milliseconds +=
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
                .count();
    }
    m_gl.UseProgram(program);
    ++m_uses[file];
}

GLuint Programs::compile(const std::string& file, const std::string& defines) {
    std::string source = shader_source(file, defines);
    if (strikes(Fault::shader))
        source += "this is no shader\n";
    const char* text = source.c_str();
    const GLuint shader = m_gl.CreateShader(GL_COMPUTE_SHADER);
    m_gl.ShaderSource(shader, 1, &text, nullptr);
    m_gl.CompileShader(shader);
    GLint fine = 0;
    char log[2048] = "";
    m_gl.GetShaderiv(shader, GL_COMPILE_STATUS, &fine);
    if (!fine) {
        m_gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
        m_gl.DeleteShader(shader);
        throw Failure("glCompileShader(" + file + "): " + log);
    }
    const GLuint program = m_gl.CreateProgram();
    m_gl.AttachShader(program, shader);
    m_gl.LinkProgram(program);
    m_gl.DeleteShader(shader); // goes with the program
    m_gl.GetProgramiv(program, GL_LINK_STATUS, &fine);
    if (!fine) {
        m_gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
        m_gl.DeleteProgram(program);
        throw Failure("glLinkProgram(" + file + "): " + log);
    }
    return program;
}

} // namespace ddt::gl
