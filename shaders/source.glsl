// SPDX-License-Identifier: Apache-2.0
// The pixels of the tiles as they were read. After net.glsl.

layout(std430, binding = BIND_SOURCE) readonly buffer Source { uvec4 source[]; };

vec4 source_at(ivec2 p) {
    return uintBitsToFloat(source[pixel_of(p)]);
}
