// SPDX-License-Identifier: Apache-2.0
#include "core/gl/programs.h"

#include <charconv>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/constants.h"
#include "core/base/stopwatch.h"
#include "core/gl/context/failure.h"
#include "core/gl/context/faults.h"
#include "core/gl/program_interface.h"
#include "core/gl/shader_text.h"
#include "ddt/options.h"

namespace ddt::gl {

namespace {

const char* text_of(const std::string& file) {
    for (const ShaderText* t = shader_texts; t->name; ++t)
        if (file == t->name)
            return t->text;
    throw Failure("no shader is named " + file);
}

/// Append the text, each #include "name" replaced by that file's at its first mention.
void append(const std::string& text, std::set<std::string>& included, std::string& out) {
    static const std::string include = "#include \"";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, include.size(), include) != 0) {
            out += line + '\n';
            continue;
        }
        const std::string name = line.substr(include.size(), line.rfind('"') - include.size());
        if (included.insert(name).second)
            append(text_of(name), included, out);
    }
}

std::string define(const char* name, const std::string& value) {
    return std::string("#define ") + name + ' ' + value + '\n';
}

/// The constants of core/base/constants.h; floats with as many digits as tell them from others, in
/// no locale's way. (Their bits would not do: compilers refuse uintBitsToFloat() in a constant.)
std::string constants() {
    std::string out;
    const auto put = [&](const char* type, const char* name, const std::string& value) {
        out += std::string("const ") + type + ' ' + name + " = " + value + ";\n";
    };
    const auto digits = [](float value) {
        char text[32];
        const auto end =
            std::to_chars(text, text + sizeof text, value, std::chars_format::scientific);
        return std::string(text, end.ptr);
    };
#define DDT_INT(name, value) put("int", #name, std::to_string(name));
#define DDT_FLOAT(name, value) put("float", #name, digits(name));
    DDT_CONSTANTS(DDT_INT, DDT_FLOAT)
#undef DDT_INT
#undef DDT_FLOAT
    return out;
}

} // namespace

std::string program_name(const std::string& file, const std::string& defines) {
    std::string name = file;
    std::istringstream words(defines);
    for (std::string word; words >> word;)
        name += ' ' + word;
    return name;
}

std::string shader_source(const std::string& file, const std::string& defines) {
    return assembled(text_of(file), defines);
}

std::string assembled(const std::string& text, const std::string& defines) {
    std::string out = "#version 430 core\n";
#define DDT_LAYOUT(NAME, name, value) out += define(#NAME, std::to_string(name));
    DDT_LAYOUTS(DDT_LAYOUT)
#undef DDT_LAYOUT
#define DDT_LOCATION(NAME, name) out += define(#NAME, std::to_string(name));
    DDT_LOCATIONS(DDT_LOCATION)
#undef DDT_LOCATION
#define DDT_BINDING(NAME, name, value) out += define(#NAME, std::to_string(value));
    DDT_BINDINGS(DDT_BINDING)
    DDT_UNIFORM_BINDINGS(DDT_BINDING)
#undef DDT_BINDING
    std::istringstream names(defines);
    for (std::string name; names >> name;)
        out += define(name.c_str(), "");
    out += constants();
    std::set<std::string> included;
    append(text, included, out);
    return out;
}

namespace {

/// Have it compiled and linked; `shader`, which is not 0, goes with the answer().
GLuint ask_for(const Functions& gl, const std::string& name, std::string source, GLuint& shader) {
#ifdef DDT_FAULTS
    source = with_change(name, std::move(source));
#endif
    if (strikes(Fault::shader))
        source += "this is no shader\n";
    const char* text = source.c_str();
    shader = gl.CreateShader(GL_COMPUTE_SHADER);
    if (!shader)
        throw Failure(name + ": glCreateShader failed");
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    const GLuint program = gl.CreateProgram();
    if (!program) {
        gl.DeleteShader(shader);
        throw Failure(name + ": glCreateProgram failed");
    }
    gl.AttachShader(program, shader);
    gl.LinkProgram(program);
    return program;
}

/// Wait for it. Throws Failure, and the program is deleted, if it does not compile or link.
void answer(const Functions& gl, const std::string& name, GLuint program, GLuint shader) {
    GLint compiled = 0, linked = 0;
    char log[2048] = "";
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!compiled)
        gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    else if (!linked)
        gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
    gl.DeleteShader(shader); // goes with the program
    if (linked)
        return;
    gl.DeleteProgram(program);
    throw Failure((compiled ? "glLinkProgram(" : "glCompileShader(") + name + "): " + log);
}

} // namespace

Programs::Begun::iterator Programs::begin(const std::string& file, const std::string& defines) {
    const std::string name = program_name(file, defines);
    const auto known = m_programs.find(name);
    if (known != m_programs.end())
        return known;
    const Stopwatch watch;
    Program p;
    p.program = ask_for(m_gl, name, shader_source(file, defines), p.shader);
    m_milliseconds += watch.milliseconds();
    return m_programs.emplace(name, p).first;
}

void Programs::finish(Begun::iterator begun) {
    const Stopwatch watch;
    try {
        answer(m_gl, begun->first, begun->second.program, begun->second.shader);
        begun->second.shader = 0;
    } catch (const Failure&) {
        m_programs.erase(begun);
        throw;
    }
    m_milliseconds += watch.milliseconds();
}

void Programs::expect(const std::string& file, const std::string& defines) {
    begin(file, defines);
}

void Programs::use(const std::string& file, const std::string& defines) {
    const auto p = begin(file, defines);
    if (p->second.shader)
        finish(p);
    if (before_use)
        before_use(file);
    m_gl.UseProgram(p->second.program);
    ++m_uses[file];
}

std::vector<std::string> Programs::names() const {
    std::vector<std::string> names;
    for (const auto& [name, program] : m_programs)
        names.push_back(name);
    return names;
}

GLuint compile(const Functions& gl, const std::string& name, const std::string& source) {
    GLuint shader = 0;
    const GLuint program = ask_for(gl, name, source, shader);
    answer(gl, name, program, shader);
    return program;
}

} // namespace ddt::gl
