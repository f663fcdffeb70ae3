// SPDX-License-Identifier: Apache-2.0
// A tile's numbers, as they travelled, become the values of its vertices, one invocation a pixel:
// floats, or by CODES_8 or CODES_16 codes of so many bits and a table of what they stand for.
// read_numbers() in core/gl/host_tile.cpp puts them down so.
#include "lattice.glsl"

layout(local_size_x = SURFACE_GROUP_X, local_size_y = SURFACE_GROUP_Y) in; // z: a slot

layout(std430, binding = BIND_VALUES) writeonly buffer Values { uvec4 value[]; }; // a pixel
// A tile after the other.
layout(std430, binding = BIND_NUMBERS) readonly buffer Numbers { uint numbers[]; };
layout(std430, binding = BIND_CODES) readonly buffer Codes { uint floats[]; };

layout(location = AT_CHANNELS) uniform ivec3 channels; // in a pixel; first and count of this group
// Slots a tile takes; words its numbers have room in.
layout(location = AT_LAYOUT) uniform ivec2 layout_;

uint number_at(int word, int i) {
#if defined(CODES_8)
    return floats[numbers[word + i / 4] >> 8 * (i % 4) & 0xffu];
#elif defined(CODES_16)
    return floats[numbers[word + i / 2] >> 16 * (i % 2) & 0xffffu];
#else
    return numbers[word + i];
#endif
}

void main() {
    int slot = int(gl_GlobalInvocationID.z);
    ivec2 p = ivec2(gl_GlobalInvocationID.xy), size = extent[slot].xy;
    if (p.x >= size.x || p.y >= size.y)
        return;
    int word = slot / layout_.x * layout_.y;
    int first = (p.y * size.x + p.x) * channels.x + channels.y;
    uvec4 bits = uvec4(0u);
    for (int c = 0; c < channels.z; ++c)
        bits[c] = number_at(word, first + c);
    value[slot * slot_pixels + p.y * slot_width + p.x] = bits;
}
