// Read the surface at output positions, one invocation each. C++ twins: core/sample/evaluate.cpp,
// and of the edges' bends make_edges in core/surface/net.cpp.
//
// Bends are computed here and not in a pass of their own: six floats a lane from vertices that are
// in the cache are cheaper than an array of 48 bytes a pixel through memory.
#include "lattice.glsl"
#include "surface.glsl"
#include "locate.glsl"

layout(local_size_x = 16, local_size_y = 8) in;

layout(std430, binding = 1) readonly buffer Values { uvec4 value[]; };
layout(std430, binding = 2) readonly buffer Gradients { vec4 gradient[]; };
// A separable mapping: the x of the columns, then the y of the rows; else x, y of each position.
layout(std430, binding = 3) readonly buffer Positions { int position[]; };
#ifdef WHOLE_GROUPS
layout(std430, binding = 4) writeonly buffer Result { uvec4 pixels[]; }; // `channels` / 4 a pixel
#else
layout(std430, binding = 4) writeonly buffer Result { uint pixels[]; }; // `channels` a pixel
#endif

layout(location = 0) uniform int tile;
layout(location = 1) uniform bool separable;
layout(location = 2) uniform ivec3 size;     // columns and rows of invocations, positions in all
layout(location = 3) uniform ivec2 first;    // separable: of the first column and row in `position`
layout(location = 4) uniform ivec3 channels; // in a pixel; first and count of this group
layout(location = 5) uniform uint nearest;   // a bit a channel

vec4 value_at(int pixel) {
    return uintBitsToFloat(value[pixel]);
}

// The bend of the edge from vertex i to vertex j of the triangle, from the smaller address.
vec4 bend(int i, int j, ivec2 v, vec4 zi, vec4 zj) {
    return edge_bend(gradient[2 * i], gradient[2 * i + 1], gradient[2 * j], gradient[2 * j + 1],
                     zi, zj, v);
}

void main() {
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    int index = y * size.x + x;
    if (x >= size.x || y >= size.y || index >= size.z)
        return;
    ivec2 p = separable ? ivec2(position[first.x + x], position[first.y + y])
                        : ivec2(position[2 * index], position[2 * index + 1]);
    Triangle t = locate(tile, p);
    int at_vertex[3];
    for (int k = 0; k < 3; ++k)
        at_vertex[k] = tile * slot_pixels + t.vertex[k].y * slot_width + t.vertex[k].x;

    Patch patch_;
    patch_.z0 = value_at(at_vertex[0]);
    patch_.z1 = value_at(at_vertex[1]);
    patch_.z2 = value_at(at_vertex[2]);
#ifdef QUADRATIC
    const bool quadratic = true;
    ivec2 p01 = t.vertex[1] - t.vertex[0], p02 = t.vertex[2] - t.vertex[0];
    patch_.e01 = bend(at_vertex[0], at_vertex[1], p01, patch_.z0, patch_.z1);
    patch_.e20 = bend(at_vertex[0], at_vertex[2], p02, patch_.z0, patch_.z2);
    if (before(t.vertex[1], t.vertex[2]))
        patch_.e12 = bend(at_vertex[1], at_vertex[2], p02 - p01, patch_.z1, patch_.z2);
    else
        patch_.e12 = bend(at_vertex[2], at_vertex[1], p01 - p02, patch_.z2, patch_.z1);
#else
    const bool quadratic = false;
#endif
    find_range(patch_);

    const float unit = 1.0 / float(position_one);
    float b0 = float(t.weight.x) * unit, b1 = float(t.weight.y) * unit,
          b2 = float(t.weight.z) * unit;
    uvec4 bits = result_bits(at(patch_, b0, b1, b2, quadratic));
    if (nearest != 0u) {
        ivec3 w = t.weight;
        int most = w.y > w.x ? (w.z > w.y ? 2 : 1) : (w.z > w.x ? 2 : 0);
        uvec4 copied = value[at_vertex[most]];
        bvec4 copy = notEqual(uvec4(nearest) & uvec4(1u, 2u, 4u, 8u), uvec4(0u));
        bits = if_true(copy, copied, bits);
    }
#ifdef WHOLE_GROUPS
    pixels[index * (channels.x / 4) + channels.y / 4] = bits;
#else
    for (int c = 0; c < channels.z; ++c)
        pixels[index * channels.x + channels.y + c] = bits[c];
#endif
}
