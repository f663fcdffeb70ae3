// SPDX-License-Identifier: Apache-2.0
// Where things are in the buffer `Work` of shaders/counts.glsl.
#pragma once

#include "core/gl/device_mesh.h"

namespace ddt::gl {

/// Groups of an iteration's dispatches.
enum class Step { evaluate, select, flip, count };
struct Arguments {
    GLuint x, y, z;
};
constexpr size_t arguments_of(int iteration, Step step) {
    return sizeof(Arguments) * (size_t(iteration) * size_t(Step::count) + size_t(step));
}

constexpr size_t reach_offset = arguments_of(most_iterations + 2, Step::evaluate);
constexpr size_t counts_offset = reach_offset + sizeof(Reach) * max_tiles;

constexpr size_t work_bytes(int tiles) {
    return counts_offset + sizeof(IterationCounts) * size_t(most_iterations + 2) * size_t(tiles);
}

} // namespace ddt::gl
