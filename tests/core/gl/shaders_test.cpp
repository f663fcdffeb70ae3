// SPDX-License-Identifier: Apache-2.0
// The shaders before the reference compiler: accepted in every variant, and no float operation in
// them may be contracted with another. That is what `precise` is for; one that was forgotten shows
// here, while the compilers of the other tests may not make use of it.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/gl/job_programs.h"
#include "core/gl/program_interface.h"
#include "core/gl/programs.h"
#include "core/gl/shader_text.h"
#include "ddt/names.h"
#include "tests/temporary.h"

namespace ddt::test {
namespace {

/// By their files and macros.
using Variants = std::map<std::string, gl::JobProgram>;

bool is_program(const std::string& file) {
    const std::string end = ".comp";
    return file.size() > end.size() && file.substr(file.size() - end.size()) == end;
}

/// Those that compare floats at most: they choose and flip edges, draw numbers or move bits.
bool integers_only(const std::string& name, const gl::JobProgram& program) {
    static const std::set<std::string> known = {
        "select.comp",      "flip.comp",       "anneal_flip.comp",
        "anneal_draw.comp", "unpack.comp",     "tin_anneal_draw.comp",
        "tin_accept.comp",  "tin_reject.comp", "pack.comp CODES"};
    return known.count(program.file) > 0 || known.count(name) > 0;
}

void add(const Job& job, const gl::Transfer& transfer, Variants& all) {
    for (const gl::JobProgram& program : gl::job_programs(job, transfer))
        all[gl::program_name(program.file, program.macros)] = program;
}

void add_meshes(Variants& all) {
    Job job;
    for (const std::string& cost : cost_names())
        for (const std::string& scheme : scheme_names())
            for (const float contour : {0.0f, 0.8f})
                for (const int iterations : {0, 64}) {
                    find_cost(cost, job.mesh.cost);
                    find_scheme(scheme, job.mesh);
                    job.mesh.contour = contour;
                    job.mesh.max_iterations = iterations;
                    add(job, {}, all);
                }
}

void add_surfaces(Variants& all) {
    Job job;
    for (const Surface kind : {Surface::linear, Surface::patch})
        for (const float soft : {0.0f, 0.4f})
            for (const int consistency : {0, 1})
                for (const bool fitted : {false, true})
                    for (const int channels : {3, 4})
                        for (const int meshes : {1, 2}) {
                            job.surface.kind = kind;
                            job.surface.soft = soft;
                            job.surface.consistency = consistency;
                            job.surface.fitted = fitted;
                            job.channels = channels;
                            job.mesh.meshes = meshes;
                            add(job, {}, all);
                        }
}

void add_transfers(Variants& all) {
    using Download = gl::Transfer::Download;
    for (const int bytes : {1, 2, 4})
        for (const Download download : {Download::floats, Download::halfs, Download::codes}) {
            gl::Transfer transfer;
            transfer.upload.bytes = bytes;
            transfer.download = download;
            add({}, transfer, all);
        }
}

/// Those of meshes of points, which no job has: core/gl/device_tin.cpp.
void add_points(Variants& all) {
    for (const gl::ShaderText* shader = gl::shader_texts; shader->name; ++shader) {
        const std::string file = shader->name;
        if (!is_program(file) || file.compare(0, 4, "tin_") != 0)
            continue;
        for (const std::string& cost : cost_names()) {
            const std::string macros = "COST_" + cost;
            all[gl::program_name(file, macros)] = {file, macros};
        }
    }
}

/// All that there are.
Variants variants() {
    Variants all;
    add_meshes(all);
    add_surfaces(all);
    add_transfers(all);
    add_points(all);
    return all;
}

/// What the compiler prints for the shader: messages and the code it makes of it.
std::string compiled(const gl::JobProgram& program) {
    const std::string file = temporary("shader.comp");
    std::ofstream(file) << gl::shader_source(program.file, program.macros);
    const std::string command =
        "glslangValidator -G -H -S comp -o " + temporary("shader.spv") + " " + file;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    std::string text;
    char part[4096];
    while (const size_t n = fread(part, 1, sizeof part, pipe))
        text.append(part, n);
    pclose(pipe);
    return text;
}

/// Expect what the compiler printed to be of a shader without faults, each operation on floats
/// decorated. Returns how many there are.
int expect_exact(const std::string& name, const std::string& printed) {
    static const std::set<std::string> operations_of_floats = {"FAdd", "FSub", "FMul", "FDiv",
                                                               "VectorTimesScalar"};
    EXPECT_EQ(printed.find("ERROR"), std::string::npos) << name << ": " << printed.substr(0, 500);
    std::set<int> exact; // by their numbers, which stand before a name or a colon
    int operations = 0;
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream of_line(line);
        const std::vector<std::string> words(std::istream_iterator<std::string>(of_line), {});
        if (words.size() == 3 && words[0] == "Decorate" && words[2] == "NoContraction") {
            exact.insert(std::stoi(words[1]));
        } else if (words.size() > 2 && (operations_of_floats.count(words[2]) ||
                                        line.find("(Fma)") != std::string::npos)) {
            EXPECT_TRUE(exact.count(std::stoi(words[0]))) << name << ": not precise: " << line;
            ++operations;
        }
    }
    return operations;
}

TEST(Shaders, TheReferenceCompilerTakesThemAndContractsNothing) {
    if (std::system("glslangValidator --version >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslangValidator is not installed (./check installs it)";
    for (const auto& [name, program] : variants()) {
        const int operations = expect_exact(name, compiled(program));
        // Else neither would a forgotten `precise` be seen.
        EXPECT_EQ(operations > 0, !integers_only(name, program)) << name;
    }
}

TEST(Shaders, AreAllLookedAt) {
    std::set<std::string> looked_at;
    for (const auto& [name, program] : variants())
        looked_at.insert(program.file);
    for (const gl::ShaderText* shader = gl::shader_texts; shader->name; ++shader)
        EXPECT_EQ(looked_at.count(shader->name) > 0, is_program(shader->name)) << shader->name;
}

// A number, which C++ would have to say again, is no name of core/gl/program_interface.h.
TEST(Shaders, SayByNamesWhereUniformsAndBuffersAre) {
    std::set<std::string> known, used;
#define ADD(NAME, ...) known.insert(#NAME);
    DDT_LOCATIONS(ADD)
    DDT_BINDINGS(ADD)
    DDT_UNIFORM_BINDINGS(ADD)
#undef ADD
    const std::regex place("\\b(location|binding)\\s*=\\s*(\\w+)");
    for (const gl::ShaderText* shader = gl::shader_texts; shader->name; ++shader) {
        const std::string text = shader->text;
        for (std::sregex_iterator match(text.begin(), text.end(), place), end; match != end;
             ++match) {
            EXPECT_TRUE(known.count((*match)[2])) << shader->name << ": " << match->str();
            used.insert((*match)[2]);
        }
    }
    EXPECT_EQ(used, known);
}

// OpenGL 4.3 promises as many places to bind buffers to, and a program as many storage blocks.
TEST(Shaders, BindNoMoreThanIsPromised) {
#define EXPECT_PLACE(NAME, name, value) EXPECT_LT(value, 8) << #NAME;
    DDT_BINDINGS(EXPECT_PLACE)
#undef EXPECT_PLACE
}

} // namespace
} // namespace ddt::test
