// SPDX-License-Identifier: Apache-2.0
// Results made smaller before they travel: HALFS, two 16-bit floats a word, or CODES, four bytes.
// C++ twins: core/base/half.h, core/base/code_table.cpp.
#ifdef HALFS
#include "half.glsl"
#define PACKED half_of_float
const int in_word = 2;
#else
#include "codes.glsl"
#define PACKED encode
const int in_word = 4;
#endif

layout(local_size_x = LIST_GROUP) in;

layout(std430, binding = BIND_RESULTS) readonly buffer Results { uint result[]; };
layout(std430, binding = BIND_PACKED) writeonly buffer Packed { uint packed_[]; };

layout(location = AT_COUNT) uniform int count; // of results

void main() {
    int all = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i * in_word < count; i += all) {
        uint word = 0u;
        for (int k = 0; k < in_word && i * in_word + k < count; ++k)
            word |= PACKED(result[i * in_word + k]) << 32 / in_word * k;
        packed_[i] = word;
    }
}
