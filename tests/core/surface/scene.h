// SPDX-License-Identifier: Apache-2.0
// Meshes with random edges flipped, and values for their pixels.
#pragma once

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/float_bits.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/guides.h"
#include "tests/core/lattice/faces.h"
#include "tests/core/lattice/flipping.h"
#include "tests/core/random_values.h"

namespace ddt::test {

/// A mesh over random numbers, its triangles, and how to read surfaces over it.
struct Scene {
    Lattice lattice;
    std::vector<Face> faces;

    Scene(int width, int height, int flips, Random& random) {
        const auto guide = make_guide(Kind::noise, width, height, random.bits());
        lattice.start(width, height, guide.data(), true);
        flip_at_random(lattice, flips, random);
        finish();
    }
    void finish() {
        faces = faces_of(lattice);
        lattice.find_divisions(lattice.all());
        lattice.find_first_edges(lattice.all());
        find_all_gains(lattice, Cost::abn);
    }
    Rect all() const { return lattice.all(); }
    size_t pixels() const { return size_t(lattice.width()) * size_t(lattice.height()); }
};

/// Call f(scene, random) for several meshes, one of them with edges as long as they get.
template <class F>
void each_scene(F&& f) {
    Random random(99);
    for (const Pixel size : {Pixel{2, 2}, Pixel{2, 5}, Pixel{8, 3}, Pixel{13, 10}})
        for (const int flips : {0, 15, 600}) {
            SCOPED_TRACE(::testing::Message()
                         << size.x << " x " << size.y << ", " << flips << " flips");
            Scene scene(size.x, size.y, flips, random);
            f(scene, random);
        }
    SCOPED_TRACE("longest edges");
    Scene scene(80, 2, 0, random);
    flip_to_longest(scene.lattice);
    scene.finish();
    f(scene, random);
}

/// Pixel values of all sorts.
enum class Values { unit, hdr, wild, nonfinite };
inline constexpr Values all_values[] = {Values::unit, Values::hdr, Values::wild, Values::nonfinite};

inline std::vector<float> make_values(Values kind, size_t n, Random& random) {
    return fill(n, [&] {
        switch (kind) {
        case Values::unit:
            return random_value(random);
        case Values::hdr:
            return random_hdr(random);
        case Values::wild:
            return random_wild(random);
        case Values::nonfinite:
        default:
            break;
        }
        const float inf = std::numeric_limits<float>::infinity();
        const float odd[] = {inf, -inf, float_of(0x7fc00000), float_of(0xffc12345), 3.4e38f};
        return random.below(8) ? random_value(random) : odd[random.below(5)];
    });
}

} // namespace ddt::test
