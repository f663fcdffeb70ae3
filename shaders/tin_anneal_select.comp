// SPDX-License-Identifier: Apache-2.0
// Which edges of a part are outside each other's 2-region and flip; tin_flip.comp does it. C++
// twin: Annealing::select() and iterate() in core/triangulate/annealing.h.
#define DRAWN readonly
#include "tin.glsl"
#include "annealing.glsl"

bool is_selected(int m) {
    int region[wide_region_size];
    region_of(m, false, region);
    for (int k = 0; k < wide_region_size; ++k) {
        int other = region[k];
        if (other >= 0 && is_of_part(drawn[other]) &&
            draws_before(other, drawn[other], m, drawn[m]) && flippable(other))
            return false;
    }
    return true;
}

void main() {
    int m = own_index();
    if (m >= count)
        return;
    uint state = idle;
    if (is_of_part(drawn[m]) && flippable(m) && is_selected(m)) {
        atomicAdd(evaluated, 1u);
        if (is_taken(flip_gain(m), drawn[m]))
            state = accepted;
    }
    mark[m] = state;
}
