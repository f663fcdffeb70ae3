// SPDX-License-Identifier: Apache-2.0
// What is known of the work on the tiles.

struct Counts {
    uint evaluated, candidates, selected, blocked, dirty, rounds;
};
layout(std430, binding = BIND_WORK) ACCESS buffer Work {
    // Groups of indirect dispatches, (x, tiles, 1) each: one a step of an iteration.
    uint arguments[ARGUMENT_WORDS * ITERATION_STEPS * (MAX_ITERATIONS + 2)];
    // Four a tile: how far edges beyond its left, upper, right and lower side go (reach.glsl).
    uint reach[4 * MAX_TILES];
    Counts counts[]; // iteration * tiles + tile; `dirty` is what the iteration evaluates
};
