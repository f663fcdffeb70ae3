// SPDX-License-Identifier: Apache-2.0
// Where things are in the buffer `Work` of shaders/counts.glsl.
#pragma once

#include "core/gl/device_mesh.h"

namespace ddt::gl {

/// What one of an iteration's dispatches does.
enum class Step { evaluate = step_evaluate, select = step_select, flip = step_flip };
/// Where its arguments are: groups in x, y, z. Twin: arguments_of() in shaders/lists.glsl.
constexpr size_t arguments_of(int iteration, Step step) {
    return sizeof(GLuint) * size_t(argument_words * (iteration_steps * iteration + int(step)));
}

constexpr size_t reach_offset = arguments_of(most_iterations + 2, Step::evaluate);
constexpr size_t counts_offset = reach_offset + sizeof(Reach) * max_tiles;

constexpr size_t counts_bytes = sizeof(IterationCounts) * size_t(most_iterations + 2); // a tile's

} // namespace ddt::gl
