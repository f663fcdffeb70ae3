// SPDX-License-Identifier: Apache-2.0
// The shaders before the reference compiler: accepted in every variant, and no float operation in
// them may be contracted with another. That is what `precise` is for; one that was forgotten shows
// here, while the compilers of the other tests may not make use of it.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "core/gl/programs.h"
#include "ddt/names.h"
#include "tests/temporary.h"

namespace ddt::test {
namespace {

struct Variant {
    std::string file, defines;
    /// Choosing and flipping edges compares floats at most.
    bool integers_only() const {
        return file == "select.comp" || file == "flip.comp" || file == "anneal_flip.comp" ||
               file == "anneal_draw.comp" || file == "tin_anneal_draw.comp";
    }
};

std::vector<Variant> variants() {
    std::vector<Variant> all = {{"select.comp", ""},      {"flip.comp", ""},
                                {"gradients.comp", ""},   {"contours.comp", ""},
                                {"anneal_draw.comp", ""}, {"anneal_flip.comp", ""}};
    for (const std::string& cost : cost_names())
        for (const char* file :
             {"start.comp", "evaluate.comp", "evaluate.comp DENSE",
              "evaluate.comp DENSE CANDIDATES", "finish.comp", "accept_reject.comp",
              "anneal_select.comp", "anneal_select.comp CONTOURS", "start.comp CONTOURS",
              "tin_faces.comp", "tin_evaluate.comp", "tin_anneal_draw.comp",
              "tin_anneal_select.comp"}) {
            const std::string name = file;
            const size_t space = name.find(' ');
            all.push_back({name.substr(0, space),
                           "COST_" + cost + (space == name.npos ? "" : name.substr(space))});
        }
    all.push_back({"gradients.comp", "FITTED"});
    for (const char* net :
         {"", "QUADRATIC", "SOFT", "QUADRATIC SOFT", "QUADRATIC FITTED", "QUADRATIC SOFT FITTED"})
        all.push_back({"correct.comp", std::string("STORED_EDGES ") + net});
    for (const char* net : {"QUADRATIC", "SOFT", "QUADRATIC SOFT"})
        all.push_back({"net_edges.comp", net});
    for (const char* net : {"QUADRATIC", "QUADRATIC SOFT"})
        all.push_back({"fitted_bends.comp", std::string("STORED_EDGES ") + net});
    for (const char* net : {"", "QUADRATIC", "SOFT", "QUADRATIC SOFT", "QUADRATIC STORED_BENDS",
                            "QUADRATIC SOFT STORED_BENDS"})
        for (const char* result : {"", " WHOLE_GROUPS", " MEAN", " WHOLE_GROUPS MEAN"})
            all.push_back({"sample.comp", std::string(net) + result});
    return all;
}

/// What the compiler prints for the shader: messages and the code it makes of it.
std::string compiled(const Variant& v) {
    const std::string file = temporary("shader.comp");
    std::ofstream(file) << gl::shader_source(v.file, v.defines);
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

TEST(Shaders, TheReferenceCompilerTakesThemAndContractsNothing) {
    if (std::system("glslangValidator --version >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslangValidator is not installed (./check installs it)";
    const std::regex decoration("Decorate (\\d+)(?:\\([^)]*\\))? NoContraction"),
        operation(
            "^\\s*(\\d+)(?:\\([^)]*\\))?:.*\\b(FAdd|FSub|FMul|FDiv|VectorTimesScalar|Fma)\\b");
    for (const Variant& v : variants()) {
        const std::string text = compiled(v), what = v.file + " " + v.defines;
        EXPECT_EQ(text.find("ERROR"), std::string::npos) << what << ": " << text.substr(0, 500);
        std::set<std::string> exact;
        int operations = 0;
        std::istringstream lines(text);
        std::smatch match;
        for (std::string line; std::getline(lines, line);) {
            if (std::regex_search(line, match, decoration)) {
                exact.insert(match[1]);
            } else if (std::regex_search(line, match, operation)) {
                EXPECT_TRUE(exact.count(match[1])) << what << ": not precise: " << line;
                ++operations;
            }
        }
        // Else neither would a forgotten `precise` be seen.
        EXPECT_EQ(operations > 0, !v.integers_only()) << what;
    }
}

// OpenGL 4.3 promises a program eight storage blocks, and as many places to bind buffers to.
TEST(Shaders, BindNoMoreThanIsPromised) {
    const std::regex block("binding = (\\d+)\\).*\\bbuffer\\b");
    for (const Variant& v : variants()) {
        std::istringstream lines(gl::shader_source(v.file, v.defines));
        std::smatch match;
        int blocks = 0;
        for (std::string line; std::getline(lines, line);)
            if (std::regex_search(line, match, block)) {
                EXPECT_LT(std::stoi(match[1]), 8) << v.file << " " << v.defines << ": " << line;
                ++blocks;
            }
        EXPECT_GT(blocks, 0) << v.file;
    }
}

} // namespace
} // namespace ddt::test
