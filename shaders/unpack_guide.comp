// SPDX-License-Identifier: Apache-2.0
// A tile's guide as it travelled becomes floats, one invocation a pixel: undoes what encode_guide()
// in core/gl/transfer.cpp does.
#include "lattice.glsl"

layout(local_size_x = SURFACE_GROUP_X, local_size_y = SURFACE_GROUP_Y) in; // z: a tile

// A slot after the other: whether these are steps; then the guide, rows without gaps.
layout(std430, binding = BIND_ENCODED) readonly buffer Encoded { uint encoded[]; };
layout(std430, binding = BIND_GUIDE) writeonly buffer Guide { uint guide[]; };

void main() {
    int slot = int(gl_GlobalInvocationID.z);
    ivec2 p = ivec2(gl_GlobalInvocationID.xy), size = extent[slot].xy;
    if (p.x >= size.x || p.y >= size.y)
        return;
    int first = slot * (slot_pixels + 1), i = p.y * size.x + p.x;
    uint bits;
    if (encoded[first] != 0u) {
        uint steps = encoded[first + 1 + i / 2] >> 16 * (i % 2) & 0xffffu;
        precise float v = float(steps) * guide_unit + guide_of_nothing;
        bits = floatBitsToUint(v);
    } else {
        bits = encoded[first + 1 + i];
    }
    guide[slot * slot_pixels + p.y * slot_width + p.x] = bits;
}
