// SPDX-License-Identifier: Apache-2.0
// 8-bit codes of floats by a table; see ddt/code_table.h.

layout(std430, binding = BIND_CODE_TABLE) readonly buffer CodeTable { uint entries[]; };

// Shift, first; lowest and top as their bits.
layout(location = AT_CODE_TABLE) uniform uvec4 code_table;

// The code of the float of these bits. By its bits alone: what devices make of NaN is their own.
// C++ twin: encode_vector() in core/base/code_table.cpp.
uint encode(uint bits) {
    int shift = int(code_table.x);
    bool is_nan = (bits & 0x7fffffffu) > 0x7f800000u;
    int v = is_nan ? 0 : int(bits); // negative where the number is
    uint within_table = uint(clamp(v, int(code_table.z), int(code_table.w)));
    uint entry = entries[(within_table >> shift) - code_table.y];
    uint within = within_table & ((1u << shift) - 1u);
    return (entry >> 24) + uint(within >= (entry & 0xffffffu));
}
