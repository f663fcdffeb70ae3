// SPDX-License-Identifier: Apache-2.0
// What a group appends to a list, collected first so that the list's counter is touched once a
// group. Before it: own_most, how much that can be.

shared uint own_count, own_base;
shared int own_list[own_most];

void begin_list() {
    if (gl_LocalInvocationIndex == 0)
        own_count = 0;
    barrier();
}
void collect(int m) {
    own_list[atomicAdd(own_count, 1)] = m;
}
// After a barrier since own_base was set.
void append_list(int tile) {
    const uint size = gl_WorkGroupSize.x * gl_WorkGroupSize.y;
    for (uint i = gl_LocalInvocationIndex; i < own_count; i += size)
        to[tile * list_size + int(own_base + i)] = own_list[i];
}
