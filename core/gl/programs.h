// SPDX-License-Identifier: Apache-2.0
// Compute programs from the embedded shaders.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/gl/context/functions.h"
#include "ddt/options.h"

namespace ddt::gl {

/// Numbers that dispatches and shaders must agree on: a constexpr here, a macro in every shader.
#define DDT_LAYOUTS(LAYOUT)                                                                        \
    /* Tiles that one dispatch can hold. */                                                        \
    LAYOUT(MAX_TILES, max_tiles, 64)                                                               \
    /* Largest value of MeshOptions::max_iterations. */                                            \
    LAYOUT(MAX_ITERATIONS, max_iterations, most_iterations)                                        \
    /* Steps of an iteration of one_round, each a dispatch, and words of its arguments. */         \
    LAYOUT(STEP_EVALUATE, step_evaluate, 0)                                                        \
    LAYOUT(STEP_SELECT, step_select, 1)                                                            \
    LAYOUT(STEP_FLIP, step_flip, 2)                                                                \
    LAYOUT(ITERATION_STEPS, iteration_steps, 3)                                                    \
    LAYOUT(ARGUMENT_WORDS, argument_words, 3)                                                      \
    /* Words of a tile's progress in accept_reject.comp. */                                        \
    LAYOUT(PROGRESS_SIZE, progress_size, 9)                                                        \
    /* What the first is in the end, and where a round accepted none, which cannot be. */          \
    LAYOUT(PROGRESS_ENDED, progress_ended, 2)                                                      \
    LAYOUT(PROGRESS_STUCK, progress_stuck, 3)                                                      \
    /* An edge's mark, that it is to be evaluated (accept_reject.comp, tin.glsl). */               \
    LAYOUT(MARK_DIRTY, mark_dirty, 1)                                                              \
    /* Groups of invocations: over entries of a list; a tile's late iterations; over pixels of */  \
    /* the starting mesh, sites whose gains are found, pixels of the surface, samples; over */     \
    /* edges or triangles of a mesh of points. */                                                  \
    LAYOUT(LIST_GROUP, list_group, 64)                                                             \
    LAYOUT(FINISH_GROUP, finish_group, 512)                                                        \
    LAYOUT(START_GROUP_X, start_group_x, 32)                                                       \
    LAYOUT(START_GROUP_Y, start_group_y, 8)                                                        \
    LAYOUT(GAINS_GROUP_X, gains_group_x, 32)                                                       \
    LAYOUT(GAINS_GROUP_Y, gains_group_y, 4)                                                        \
    LAYOUT(SURFACE_GROUP_X, surface_group_x, 16)                                                   \
    LAYOUT(SURFACE_GROUP_Y, surface_group_y, 8)                                                    \
    LAYOUT(SAMPLE_GROUP_X, sample_group_x, 16)                                                     \
    LAYOUT(SAMPLE_GROUP_Y, sample_group_y, 8)                                                      \
    LAYOUT(TIN_GROUP, tin_group, 256)

#define DDT_LAYOUT(NAME, name, value) constexpr int name = value;
DDT_LAYOUTS(DDT_LAYOUT)
#undef DDT_LAYOUT

/// Groups of invocations along an axis of a dispatch: as many as OpenGL promises.
constexpr int most_groups = 65535;

/// The programs that were begun so far. To be used on the context's thread.
class Programs {
public:
    explicit Programs(const Functions& gl) : m_gl(gl) {}

    /// Use the program of shader `file` with the macros named in `defines` (separated by spaces),
    /// compiling it at the first use. Throws Failure with the compiler's messages.
    void use(const std::string& file, const std::string& defines = "");
    /// Have it compiled, and do not ask how that went until use(): drivers that have threads for it
    /// compile several side by side, until they are asked about one.
    void expect(const std::string& file, const std::string& defines);

    /// How often each shader was used, whatever its macros: nearly all uses are one dispatch.
    const std::map<std::string, int>& uses() const { return m_uses; }
    /// Programs begun, which may be compiling still.
    int begun() const { return int(m_programs.size()); }
    /// The programs begun, by file and macros.
    std::vector<std::string> names() const;
    double milliseconds() const { return m_milliseconds; }

    /// Called with the shader's file before a program is used, for a clock.
    std::function<void(const std::string& file)> before_use;

private:
    struct Program {
        GLuint program = 0;
        GLuint shader = 0; ///< none any more once it is known how compiling went
    };
    using Begun = std::map<std::string, Program>;
    Begun::iterator begin(const std::string& file, const std::string& defines);
    void finish(Begun::iterator begun);

    const Functions& m_gl;
    Begun m_programs; ///< by name
    std::map<std::string, int> m_uses;
    double m_milliseconds = 0; ///< spent compiling
};

/// A program's name: its file and its macros, single spaces between.
std::string program_name(const std::string& file, const std::string& defines);

/// The text given to the compiler: version, macros, constants, and the file with its includes, each
/// once. assembled(): of a text that is no file of shaders/.
std::string shader_source(const std::string& file, const std::string& defines);
std::string assembled(const std::string& text, const std::string& defines);

/// Compile and link. Throws Failure with the compiler's messages.
GLuint compile(const Functions& gl, const std::string& name, const std::string& source);

} // namespace ddt::gl
