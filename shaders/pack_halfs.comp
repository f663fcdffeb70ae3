// SPDX-License-Identifier: Apache-2.0
// Results as 16-bit floats, two a word, before they travel. C++ twin: Sink::write_halfs()'s users.
#include "half.glsl"

layout(local_size_x = LIST_GROUP) in;

layout(std430, binding = 5) readonly buffer Results { uint result[]; };
layout(std430, binding = 6) writeonly buffer Halfs { uint halfs[]; };

layout(location = 0) uniform int count; // of results

void main() {
    int all = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = 2 * int(gl_GlobalInvocationID.x); i < count; i += 2 * all) {
        uint second = i + 1 < count ? half_of_float(result[i + 1]) : 0u;
        halfs[i / 2] = half_of_float(result[i]) | second << 16;
    }
}
