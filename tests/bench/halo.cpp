// SPDX-License-Identifier: Apache-2.0
// How far from a cut a mesh differs from the whole image's: what tile_halo (core/tiles/grid.h) has
// to be at least.
//
//   halo FOLDER [FILTER]...
//
// Each picture's mesh is compared with those of cuts of it, edge by edge. For each filter's mesh:
// how many edges were compared, how many of them differ, and how far, in pixels, the farthest lies
// from the cut's border.
#include <algorithm>
#include <cstdio>
#include <set>

#include "core/base/float_mode.h"
#include "core/guide/guide.h"
#include "core/lattice/lattice.h"
#include "core/triangulate/triangulate.h"
#include "ddt/option_table.h"
#include "tests/bench/light.h"
#include "tests/bench/reference.h"

namespace {

using namespace ddt;

constexpr int cut_size = 160, cut_step = 61;

struct Guide {
    int width = 0, height = 0;
    std::vector<float> values;
    std::vector<float> cut(const Rect& r) const {
        std::vector<float> part;
        for (int y = r.y0; y < r.y1; ++y)
            part.insert(part.end(), &values[size_t(y) * size_t(width) + size_t(r.x0)],
                        &values[size_t(y) * size_t(width) + size_t(r.x0)] + r.width());
        return part;
    }
};

/// Every step of making a mesh that looks at neighbours.
void make_mesh(std::vector<float> guide, int width, int height, const MeshOptions& options,
               Lattice& lattice) {
    const DenormalsAreZero as_in_the_product;
    Workspace workspace;
    Statistics statistics;
    blur_guide(guide.data(), width, height, blur_share(options, 0));
    start(lattice, width, height, guide.data(), options);
    triangulate(lattice, options, workspace, statistics);
}

struct Count {
    size_t compared = 0, differing = 0;
    int farthest = 0;
};

/// Edges of the cut `r` of the whole mesh that differ; borders that are the picture's own are none.
void compare(const Lattice& whole, const Lattice& part, const Rect& r, Count& count) {
    part.each_edge([&](int m) {
        const int x = m % part.stride(), y = m / part.stride();
        const int none = 2 * (whole.width() + whole.height());
        const int distance = std::min({r.x0 > 0 ? x : none, r.y0 > 0 ? y : none,
                                       r.x1 < whole.width() ? 2 * (r.width() - 1) - x : none,
                                       r.y1 < whole.height() ? 2 * (r.height() - 1) - y : none});
        const Edge &a = part.edge(m), &b = whole.edge(whole.site(2 * r.x0 + x, 2 * r.y0 + y));
        ++count.compared;
        if (a.v.x == b.v.x && a.v.y == b.v.y)
            return;
        ++count.differing;
        count.farthest = std::max(count.farthest, distance / 2);
    });
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "halo FOLDER [FILTER]...\n");
        return 2;
    }
    const std::vector<std::string> files = bench::image_files(argv[1]);
    if (files.empty()) {
        std::fprintf(stderr, "halo: no images in %s\n", argv[1]);
        return 1;
    }
    std::vector<std::string> filters(argv + 2, argv + argc);
    if (filters.empty())
        filters = {"ddt", "ddt-sharp", "ddt-linear", "ddt,contour=0"};
    std::set<std::string> told;
    for (const std::string& filter : filters) {
        FilterOptions options;
        std::string error;
        if (!parse_filter(filter, options, error)) {
            std::fprintf(stderr, "halo: %s\n", error.c_str());
            return 2;
        }
        for (const bench::Light light : {bench::Light::encoded, bench::Light::linear}) {
            Count count;
            for (const std::string& file : files) {
                metrics::Image image;
                if (!bench::read_original(file, 1, light, image, error)) {
                    if (told.insert(file).second)
                        std::fprintf(stderr, "%s is left out: %s\n", file.c_str(), error.c_str());
                    continue;
                }
                const Guide guide{image.width(), image.height(),
                                  bench::guide_of(bench::pixels_of(image, light), light)};
                Lattice whole, part;
                make_mesh(guide.values, guide.width, guide.height, options.mesh, whole);
                for (int y = 0; y + cut_size <= guide.height; y += cut_step)
                    for (int x = 0; x + cut_size <= guide.width; x += cut_step) {
                        const Rect r{x, y, x + cut_size, y + cut_size};
                        make_mesh(guide.cut(r), cut_size, cut_size, options.mesh, part);
                        compare(whole, part, r, count);
                    }
            }
            if (count.compared == 0) {
                std::fprintf(stderr, "halo: no image in %s has %d x %d pixels\n", argv[1], cut_size,
                             cut_size);
                return 1;
            }
            std::printf("%-16s %-8s %10zu edges, %7zu differ, the farthest %2d pixels from a cut\n",
                        filter.c_str(), light == bench::Light::linear ? "linear" : "encoded",
                        count.compared, count.differing, count.farthest);
            std::fflush(stdout);
        }
    }
    return 0;
}
