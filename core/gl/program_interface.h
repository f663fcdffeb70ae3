// SPDX-License-Identifier: Apache-2.0
// Where programs have their uniforms and buffers: an enumerator here, a macro in every shader.
#pragma once

#include "core/gl/context/functions.h"

namespace ddt::gl {

/// Locations of uniforms. Each has its own, its place in this table, in whatever programs it is:
/// OpenGL promises 1024.
#define DDT_LOCATIONS(LOCATION)                                                                    \
    /* lists.glsl; contour_gain.glsl */                                                            \
    LOCATION(AT_TILES, at_tiles)                                                                   \
    LOCATION(AT_LIST_SIZE, at_list_size)                                                           \
    LOCATION(AT_FIRST_ITERATION, at_first_iteration)                                               \
    LOCATION(AT_LAST_ITERATION, at_last_iteration)                                                 \
    LOCATION(AT_MIN_GAIN, at_min_gain) /* tin.glsl, too */                                         \
    LOCATION(AT_CONTOUR_WEIGHT, at_contour_weight)                                                 \
    /* start.comp */                                                                               \
    LOCATION(AT_FLAT_START, at_flat_start)                                                         \
    LOCATION(AT_WITH_GAINS, at_with_gains)                                                         \
    /* finish.comp */                                                                              \
    LOCATION(AT_ITERATIONS_A_DISPATCH, at_iterations_a_dispatch)                                   \
    /* accept_reject.comp */                                                                       \
    LOCATION(AT_BY_GAIN, at_by_gain) /* tin.glsl, too */                                           \
    LOCATION(AT_WIDE_ITERATIONS, at_wide_iterations)                                               \
    LOCATION(AT_PROGRESS, at_progress)                                                             \
    /* annealing.glsl */                                                                           \
    LOCATION(AT_SALT, at_salt)                                                                     \
    LOCATION(AT_SEED, at_seed)                                                                     \
    LOCATION(AT_PART, at_part)                                                                     \
    LOCATION(AT_TEMPERATURE, at_temperature)                                                       \
    /* tin.glsl */                                                                                 \
    LOCATION(AT_COUNT, at_count) /* pack.comp, too */                                              \
    LOCATION(AT_PIXEL, at_pixel)                                                                   \
    LOCATION(AT_WIDE, at_wide)                                                                     \
    /* unpack.comp */                                                                              \
    LOCATION(AT_CHANNELS, at_channels) /* sample.comp, too */                                      \
    LOCATION(AT_LAYOUT, at_layout)                                                                 \
    /* served.glsl; net.glsl */                                                                    \
    LOCATION(AT_MARGIN, at_margin)                                                                 \
    LOCATION(AT_RECIPROCAL_TAU, at_reciprocal_tau)                                                 \
    /* correct.comp */                                                                             \
    LOCATION(AT_LIMIT, at_limit)                                                                   \
    LOCATION(AT_CLIPPED, at_clipped)                                                               \
    LOCATION(AT_STRENGTH, at_strength)                                                             \
    /* sample.comp */                                                                              \
    LOCATION(AT_TILE, at_tile)                                                                     \
    LOCATION(AT_SEPARABLE, at_separable)                                                           \
    LOCATION(AT_SIZE, at_size)                                                                     \
    LOCATION(AT_NEAREST, at_nearest)                                                               \
    LOCATION(AT_ALPHA, at_alpha)                                                                   \
    LOCATION(AT_SHARE, at_share)                                                                   \
    /* codes.glsl */                                                                               \
    LOCATION(AT_CODE_TABLE, at_code_table)

/// Bindings of storage blocks, of which OpenGL promises eight: those of one program differ.
#define DDT_BINDINGS(BINDING)                                                                      \
    /* Meshes. */                                                                                  \
    BINDING(BIND_SITES, sites, 0)                                                                  \
    BINDING(BIND_GAINS, gains, 1)                                                                  \
    BINDING(BIND_CONTOURS, contours, 2)                                                            \
    BINDING(BIND_FROM, from, 3)                                                                    \
    BINDING(BIND_TO, to, 4)                                                                        \
    BINDING(BIND_BLOCKED_EVEN, blocked_even, 5)                                                    \
    BINDING(BIND_BLOCKED_ODD, blocked_odd, 6)                                                      \
    BINDING(BIND_WORK, work, 7)                                                                    \
    /* In place of some of them: unpack_guide.comp, contours.comp and start.comp; */               \
    /* accept_reject.comp, which knows no contours; annealing. */                                  \
    BINDING(BIND_ENCODED, encoded, 4)                                                              \
    BINDING(BIND_GUIDE, guide, 5)                                                                  \
    BINDING(BIND_MARKS, marks, 2)                                                                  \
    BINDING(BIND_DRAWN, drawn, 5)                                                                  \
    BINDING(BIND_DECIDED, decided, 6)                                                              \
    /* Surfaces, beside sites, gains and work: vertices, and what edges are made of, which is */   \
    /* gradients, or in their place what was made of them (net.glsl). */                           \
    BINDING(BIND_GRADIENTS, gradients, 2)                                                          \
    BINDING(BIND_VALUES, values, 3)                                                                \
    /* unpack.comp */                                                                              \
    BINDING(BIND_NUMBERS, numbers, 4)                                                              \
    BINDING(BIND_CODES, codes, 5)                                                                  \
    /* What is made before sampling. */                                                            \
    BINDING(BIND_BENDS, bends, 4)                                                                  \
    BINDING(BIND_MADE_EDGES, made_edges, 5) /* net_edges.comp */                                   \
    BINDING(BIND_CORRECTED, corrected, 5)   /* correct.comp */                                     \
    BINDING(BIND_SOURCE, source, 6)         /* sample.comp, too */                                 \
    /* sample.comp, pack.comp */                                                                   \
    BINDING(BIND_POSITIONS, positions, 4)                                                          \
    BINDING(BIND_CODE_TABLE, code_table, 4)                                                        \
    BINDING(BIND_RESULTS, results, 5)                                                              \
    BINDING(BIND_PACKED, packed, 6)                                                                \
    /* Meshes of points. */                                                                        \
    BINDING(BIND_TIN_VERTICES, tin_vertices, 0)                                                    \
    BINDING(BIND_TIN_TRIANGLES, tin_triangles, 1)                                                  \
    BINDING(BIND_TIN_EDGES, tin_edges, 2)                                                          \
    BINDING(BIND_TIN_FACES, tin_faces, 3)                                                          \
    BINDING(BIND_TIN_GAINS, tin_gains, 4)                                                          \
    BINDING(BIND_TIN_DRAWN, tin_drawn, 4) /* by annealing, which has no use for gains */           \
    BINDING(BIND_TIN_MARKS, tin_marks, 5)                                                          \
    BINDING(BIND_TIN_COUNTS, tin_counts, 6)                                                        \
    BINDING(BIND_TIN_PLACES, tin_places, 7)

/// Bindings of uniform blocks.
#define DDT_UNIFORM_BINDINGS(BINDING)                                                              \
    BINDING(BIND_BATCH, batch, 0)                                                                  \
    BINDING(BIND_FITTED, fitted, 1)

enum Location : GLint {
#define DDT_LOCATION(NAME, name) name,
    DDT_LOCATIONS(DDT_LOCATION)
#undef DDT_LOCATION
};

#define DDT_BINDING(NAME, name, value) name = value,
enum class Binding : GLuint { DDT_BINDINGS(DDT_BINDING) };
enum class UniformBinding : GLuint { DDT_UNIFORM_BINDINGS(DDT_BINDING) };
#undef DDT_BINDING

} // namespace ddt::gl
