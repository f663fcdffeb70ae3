// SPDX-License-Identifier: Apache-2.0
// The contour words of a guide, one invocation a cell. C++ twin: core/guide/contour.cpp.
#define CONTOUR_ACCESS writeonly
#include "lattice.glsl"
#include "contour.glsl"
#include "contour_gain.glsl"

layout(local_size_x = START_GROUP_X, local_size_y = START_GROUP_Y) in; // z: a tile

layout(std430, binding = BIND_GUIDE) readonly buffer Guide { float guide[]; };

const int group_width = START_GROUP_X, group_height = START_GROUP_Y, reach_ = 3;
const int near_width = group_width + 2 * reach_, near_height = group_height + 2 * reach_;
shared vec3 tensor[near_height][near_width], smoothed[near_height][group_width];

int first_pixel;

float z(ivec2 p) {
    return guide[first_pixel + p.y * slot_width + p.x];
}

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    first_pixel = tile * slot_pixels;
    ivec2 last = extent[tile].xy - 2; // of the cells
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * ivec2(group_width, group_height);
    const int own = int(gl_LocalInvocationIndex), size = group_width * group_height;
    for (int i = own; i < near_width * near_height; i += size) {
        ivec2 at = ivec2(i % near_width, i / near_width);
        // At the rim the outermost cell repeats.
        ivec2 c = clamp(corner + at - reach_, ivec2(0), last);
        tensor[at.y][at.x] =
            cell_tensor(z(c), z(c + ivec2(1, 0)), z(c + ivec2(0, 1)), z(c + ivec2(1, 1)));
    }
    barrier();
    for (int i = own; i < group_width * near_height; i += size) {
        int x = i % group_width, y = i / group_width;
        smoothed[y][x] =
            smooth_(tensor[y][x], tensor[y][x + 1], tensor[y][x + 2], tensor[y][x + 3],
                    tensor[y][x + 4], tensor[y][x + 5], tensor[y][x + 6]);
    }
    barrier();
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    int x = int(gl_LocalInvocationID.x), y = int(gl_LocalInvocationID.y);
    if (all(lessThanEqual(cell, last)))
        contour_words[(tile * slot_sites + offset(2 * cell)) / 2] = contour_word(
            smooth_(smoothed[y][x], smoothed[y + 1][x], smoothed[y + 2][x], smoothed[y + 3][x],
                    smoothed[y + 4][x], smoothed[y + 5][x], smoothed[y + 6][x]));
}
