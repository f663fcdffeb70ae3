// SPDX-License-Identifier: Apache-2.0
// The lists of an iteration. C++ twin: core/triangulate/one_round.h.
//
// An iteration has three steps: evaluate the dirty edges, those that gain are candidates; select
// the best candidates; flip them, and what they touch is dirty. Each step goes through one list and
// makes the next, in two arrays that change places between steps.
//
// Lists are kept a tile: a tile's part begins at tile * list_size. An iteration's counts have a
// place of their own, so nothing needs to be reset between iterations and one read at the end tells
// all.
#include "lattice.glsl"
#include "counts.glsl"

layout(std430, binding = BIND_GAINS) ACCESS buffer Gains { float gain[]; }; // a site
layout(std430, binding = BIND_FROM) ACCESS buffer From { int from[]; };
layout(std430, binding = BIND_TO) ACCESS buffer To { int to[]; };

layout(location = AT_TILES) uniform int tiles;
layout(location = AT_LIST_SIZE) uniform int list_size;
layout(location = AT_FIRST_ITERATION) uniform int first_iteration;
layout(location = AT_LAST_ITERATION) uniform int last_iteration;
layout(location = AT_MIN_GAIN) uniform float min_gain;

int counts_of(int iteration, int tile) {
    return iteration * tiles + tile;
}

// Where the arguments of a step's dispatch are. C++ twin: core/gl/work_layout.h.
int arguments_of(int iteration, int step) {
    return ARGUMENT_WORDS * (ITERATION_STEPS * iteration + step);
}
// Groups that go over so many entries.
uint groups_for(uint entries) {
    return (entries + LIST_GROUP - 1) / LIST_GROUP;
}
