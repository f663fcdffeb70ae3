// SPDX-License-Identifier: Apache-2.0
// Lattices in which all kinds of edges cross cells.
#pragma once

#include "tests/core/helpers.h"

namespace ddt::test {

/// Call f(lattice, faces, random) for meshes of many kinds.
template <class F>
void each_flipped_mesh(F&& f) {
    uint64_t seed = 40;
    const auto one = [&](int w, int h, int flips, bool longest) {
        SCOPED_TRACE(::testing::Message() << w << " x " << h << ", " << flips << " flips");
        Random random(++seed);
        Lattice lattice;
        const auto guide = make_guide(Kind::noise, w, h, seed);
        lattice.start(w, h, guide.data(), true);
        flip_at_random(lattice, flips, random);
        if (longest)
            flip_to_longest(lattice);
        f(lattice, faces_of(lattice), random);
    };
    for (const Pixel size : {Pixel{2, 2}, Pixel{2, 6}, Pixel{7, 2}, Pixel{9, 8}, Pixel{16, 11}})
        for (const int flips : {0, 30, 1000})
            one(size.x, size.y, flips, false);
    one(80, 2, 0, true);
    one(2, 80, 0, true);
    one(12, 12, 50, true);
}

} // namespace ddt::test
