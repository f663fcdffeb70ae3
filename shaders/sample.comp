// SPDX-License-Identifier: Apache-2.0
// Read the surface at output positions, one invocation each. C++ twin: core/sample/evaluate.cpp.
#include "net.glsl"
#include "locate.glsl"
#include "source.glsl"
#include "bound_alpha.glsl"

layout(local_size_x = SAMPLE_GROUP_X, local_size_y = SAMPLE_GROUP_Y) in;

// A separable mapping: the x of the columns, then the y of the rows; else x, y of each position.
layout(std430, binding = BIND_POSITIONS) readonly buffer Positions { int position[]; };
// MEAN: the results hold the mean of other meshes' surfaces, to be made that of one more.
#if defined(MEAN) && defined(WHOLE_GROUPS)
layout(std430, binding = BIND_RESULTS) buffer Result { uvec4 pixels[]; };
#elif defined(MEAN)
layout(std430, binding = BIND_RESULTS) buffer Result { uint pixels[]; };
#elif defined(WHOLE_GROUPS)
// channels / group_size a pixel
layout(std430, binding = BIND_RESULTS) writeonly buffer Result { uvec4 pixels[]; };
#else
// `channels` a pixel
layout(std430, binding = BIND_RESULTS) writeonly buffer Result { uint pixels[]; };
#endif

layout(location = AT_TILE) uniform int tile;
layout(location = AT_SEPARABLE) uniform bool separable;
// Columns and rows of invocations, positions in all.
layout(location = AT_SIZE) uniform ivec3 size;
layout(location = AT_CHANNELS) uniform ivec3 channels; // in a pixel; first and count of this group
layout(location = AT_NEAREST) uniform uint nearest;    // a bit a channel
layout(location = AT_ALPHA) uniform uint alpha;        // likewise: those to be bounded
layout(location = AT_SHARE) uniform float share; // MEAN: of this mesh in the mean

// The bits in `mask`, a channel each.
bvec4 channels_of(uint mask) {
    return notEqual(uvec4(mask) & uvec4(1u, 2u, 4u, 8u), uvec4(0u));
}

void main() {
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    int index = y * size.x + x;
    if (x >= size.x || y >= size.y || index >= size.z)
        return;
    first_site = tile * slot_sites;
    first_pixel = tile * slot_pixels;
    ivec2 p = separable ? ivec2(position[x], position[size.x + y])
                        : ivec2(position[2 * index], position[2 * index + 1]);
    Triangle t = locate(tile, p);
    Patch patch_ = patch_of(t.vertex[0], t.vertex[1], t.vertex[2]);
    vec3 b = weights(t);
    uvec4 bits = result_bits(at(patch_, b.x, b.y, b.z));
    if (alpha != 0u) {
        vec4 bounded = bound_alpha(uintBitsToFloat(bits), tile, p);
        bits = if_true(channels_of(alpha), floatBitsToUint(bounded), bits);
    }
#ifdef MEAN
#ifdef WHOLE_GROUPS
    uvec4 mean = pixels[index * (channels.x / group_size) + channels.y / group_size];
#else
    uvec4 mean = uvec4(0u);
    for (int c = 0; c < channels.z; ++c)
        mean[c] = pixels[index * channels.x + channels.y + c];
#endif
    vec4 f = running_mean(uintBitsToFloat(mean), uintBitsToFloat(bits), share);
    bits = if_true(channels_of(nearest), mean, result_bits(f));
#else
    if (nearest != 0u) {
        ivec3 w = t.weight;
        int most = w.y > w.x ? (w.z > w.y ? 2 : 1) : (w.z > w.x ? 2 : 0);
        bits = if_true(channels_of(nearest), source[pixel_of(t.vertex[most])], bits);
    }
#endif
#ifdef WHOLE_GROUPS
    pixels[index * (channels.x / group_size) + channels.y / group_size] = bits;
#else
    for (int c = 0; c < channels.z; ++c)
        pixels[index * channels.x + channels.y + c] = bits[c];
#endif
}
