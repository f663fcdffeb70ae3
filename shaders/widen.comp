// SPDX-License-Identifier: Apache-2.0
// Values that came as half floats, one invocation a pixel of a slot.
#include "half.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 1) readonly buffer Halves { uvec2 halves[]; };
layout(std430, binding = 2) writeonly buffer Values { uvec4 value[]; };

layout(location = 0) uniform int count;

void main() {
    int i = int(gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * 65536u);
    if (i >= count)
        return;
    uvec2 h = halves[i];
    value[i] = uvec4(widened(h.x & 0xffffu), widened(h.x >> 16), widened(h.y & 0xffffu),
                     widened(h.y >> 16));
}
