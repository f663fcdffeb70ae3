// SPDX-License-Identifier: Apache-2.0
// What an annealing program is told.
#pragma once

#include <cstdint>

#include "core/gl/context/functions.h"
#include "core/gl/program_interface.h"

namespace ddt::gl {

/// The uniforms of shaders/annealing.glsl.
struct AnnealingUniforms {
    uint64_t salt, seed; ///< annealing_salt() of the iteration; mixed
    uint32_t part;       ///< below annealing_parts
    float temperature;
};

/// Set them for the program in use.
inline void set_annealing_uniforms(const Functions& gl, const AnnealingUniforms& chance) {
    gl.Uniform2ui(at_salt, GLuint(chance.salt), GLuint(chance.salt >> 32));
    gl.Uniform2ui(at_seed, GLuint(chance.seed), GLuint(chance.seed >> 32));
    gl.Uniform1ui(at_part, chance.part);
    gl.Uniform1f(at_temperature, chance.temperature);
}

} // namespace ddt::gl
