// SPDX-License-Identifier: Apache-2.0
// Meshes to try what is computed of one edge on.
#pragma once

#include "tests/core/helpers.h"

namespace ddt::test {

/// Call f(lattice) for meshes of several kinds, sizes and amounts of random flipping, among them
/// ones with edges as long as they get.
template <class F>
void each_mesh(F&& f) {
    uint64_t seed = 7;
    for (const Pixel size : {Pixel{2, 2}, Pixel{2, 7}, Pixel{9, 3}, Pixel{14, 11}})
        for (const Kind kind : all_kinds)
            for (const int flips : {0, 20, 400}) {
                Random random(++seed);
                Lattice lattice;
                const auto guide = make_guide(kind, size.x, size.y, seed);
                lattice.start(size.x, size.y, guide.data(), true, true);
                flip_at_random(lattice, flips, random);
                SCOPED_TRACE(::testing::Message() << size.x << " x " << size.y << ", kind "
                                                  << int(kind) << ", " << flips << " flips");
                f(lattice);
            }
    Lattice lattice;
    const auto guide = make_guide(Kind::noise, 150, 2, seed);
    lattice.start(150, 2, guide.data(), true, true);
    flip_to_longest(lattice);
    SCOPED_TRACE("longest edges");
    f(lattice);
}

} // namespace ddt::test
