// A vertex's first edge, given as the edge's midpoint relative to the vertex, in a key that orders
// midpoints as their addresses do.
uint first_key(ivec2 midpoint) {
    return uint(midpoint.y + 128) << 8 | uint(midpoint.x + 128);
}
ivec2 first_of_key(uint key) {
    return ivec2(int(key & 255u) - 128, int(key >> 8) - 128);
}
