// The starting mesh, one invocation a pixel. C++ twin: Lattice::start.
#include "lattice.glsl"

layout(local_size_x = 32, local_size_y = 4) in;

layout(std430, binding = 1) readonly buffer Guide { float guide[]; };

layout(location = 0) uniform bool flat_start;

int width, height, first_pixel;

float z(int x, int y) {
    return guide[first_pixel + y * slot_width + x];
}
// Whether the diagonal of the cell (x, y) goes from upper left to lower right; the cell must exist.
bool down(int x, int y) {
    precise float falling = abs(z(x, y) - z(x + 1, y + 1));
    precise float rising = abs(z(x + 1, y) - z(x, y + 1));
    return !flat_start || falling <= rising;
}

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    width = extent[tile].x;
    height = extent[tile].y;
    first_pixel = tile * slot_pixels;
    if (x >= width || y >= height)
        return;
    bool has_left = x > 0, has_above = y > 0, has_right = x + 1 < width, has_below = y + 1 < height;
    int s = tile * slot_sites + 2 * y * stride + 2 * x;

    site[s] = uvec2(floatBitsToUint(z(x, y)), no_first);
    bool own = has_right && has_below && down(x, y);
    if (has_right) {
        bool above = has_above && down(x, y - 1);
        site[s + 1] = pack(Edge(ivec2(1, 0), has_below ? ivec2(own ? 1 : -1, 2) : ivec2(0),
                                  has_above ? ivec2(above ? -1 : 1, -2) : ivec2(0)));
    }
    if (has_below) {
        bool before = has_left && down(x - 1, y);
        site[s + stride] =
            pack(Edge(ivec2(0, 1), has_left ? ivec2(-2, before ? -1 : 1) : ivec2(0),
                        has_right ? ivec2(2, own ? 1 : -1) : ivec2(0)));
    }
    if (has_right && has_below)
        site[s + stride + 1] = pack(own ? Edge(ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1))
                                          : Edge(ivec2(-1, 1), ivec2(-1, -1), ivec2(1, 1)));
}
