// SPDX-License-Identifier: Apache-2.0
#include "tools/fit/scene.h"

#include <algorithm>

#include "core/base/float_mode.h"
#include "core/guide/guide.h"
#include "core/lattice/locate.h"
#include "core/surface/fitted/scalar.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"
#include "ddt/option_table.h"
#include "tests/bench/reference.h"
#include "tests/core/surface/consistency/whole_rounds.h"
#include "tests/core/surface/whole_net.h"

namespace fit {

using namespace ddt;

namespace {

constexpr int colours = 3;

FilterOptions filter_options() {
    FilterOptions options;
    std::string error;
    parse_filter("ddt-sharp,clipped=1", options, error);
    return options;
}

void make_mesh(const std::vector<float>& pixels, int width, int height, bench::Light light,
               const FilterOptions& options, Workspace& workspace, Lattice& lattice) {
    std::vector<float> guide = bench::guide_of(pixels, light);
    blur_guide(guide.data(), width, height, blur_share(options.mesh, 0));
    Statistics statistics;
    start(lattice, width, height, guide.data(), options.mesh);
    triangulate(lattice, options.mesh, workspace, statistics);
    lattice.find_divisions(lattice.all());
    lattice.find_first_edges(lattice.all());
}

void find_kinds(Scene& scene, float tau) {
    const Lattice& lattice = scene.lattice;
    scene.kinds.resize(lattice.size());
    lattice.each_edge([&](int m) {
        const Edge& e = lattice.edge(m);
        EdgeKind& k = scene.kinds[size_t(m)];
        const float g = std::min(e.gain(), 0.0f);
        const bool can = e.flippable();
        k.length = fitted_length(e.v.x, e.v.y);
        k.kind = can ? 1 : 0;
        k.near = can ? std::max(0.0f, 1 + g / fitted_gain_scale) : 0.0f;
        k.softness = can ? std::max(0.0f, 1 + g / tau) / 2 : 0.0f;
        k.a = m - lattice.offset(e.v);
        k.b = m + lattice.offset(e.v);
        k.c = m + lattice.offset(e.left);
        k.d = m + lattice.offset(e.right());
    });
}

void locate_samples(Scene& scene) {
    const int width = scene.original.width(), height = scene.original.height();
    const auto along = [&](int i, int size) {
        const int64_t p =
            (int64_t(2 * i + 1) * position_one) / (2 * scene.scale) - position_one / 2;
        return int32_t(std::clamp<int64_t>(p, 0, int64_t(size - 1) * position_one));
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Point p{along(x, scene.lattice.width()), along(y, scene.lattice.height())};
            const Triangle t = locate(scene.lattice, p);
            int32_t w[3];
            t.weights(p, w);
            Sample s;
            for (int k = 0; k < 3; ++k) {
                s.vertex[k] = t.vertex[k];
                s.edge[k] = t.edge[k];
                s.b[k] = float(w[k]) / float(position_one);
            }
            scene.samples.push_back(s);
        }
}

/// Features of channel c, from the net whose edges were bent and the sums of a round's means.
void find_features(Scene& scene, const SurfaceOptions& options, const ControlNet& net,
                   const test::WholeRounds& consistency, int c) {
    const Lattice& lattice = scene.lattice;
    const int width = lattice.width(), height = lattice.height();
    const auto inside = [&](int x, int y) { return net.vertex(lattice.vertex_site(x, y))[c]; };
    const auto tap = [&](int x, int y) {
        return ddt::scalar::odd_mirror_tap<float>(x, y, width, height, inside);
    };
    Features& features = scene.features[c];
    features.vertices.resize(lattice.size());
    features.edges.resize(lattice.size());
    std::vector<float> index(lattice.size());
    const Correction limits{options.limit, options.clipped};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const size_t pixel =
                (size_t(y) * size_t(width) + size_t(x)) * size_t(net.count()) + size_t(c);
            const int site = lattice.vertex_site(x, y);
            ddt::scalar::VertexFeatures<float> found;
            const auto near = [&](int i, int j) { return tap(x + i, y + j); };
            found.find(-0.25f * consistency.sum()[pixel],
                       ddt::scalar::all_pixels(x, y, width, height) && limits.clipped,
                       fitted_table(), near);
            Features::Vertex& v = features.vertices[size_t(site)];
            v.z = inside(x, y);
            v.bound = found.bound;
            const float limit =
                ddt::scalar::fitted_limit(limits.limit, found.bound, fitted_table());
            ddt::scalar::find_limits({-1, -1, 2, 2}, limit, limits.clipped, near, v.low, v.high);
            v.moves = x > 0 && y > 0 && x + 1 < width && y + 1 < height;
            std::copy(std::begin(found.f), std::end(found.f), v.f);
            index[size_t(site)] = found.index;
            ddt::scalar::find_shares(found.index, fitted_table(), v.share);
        }
    }
    lattice.each_edge([&](int m) {
        const ddt::Edge& e = lattice.edge(m);
        Features::Edge& to = features.edges[size_t(m)];
        ddt::scalar::EdgeFeatures<float> found;
        const ddt::scalar::Place a{(m % lattice.stride() - e.v.x) / 2,
                                   (m / lattice.stride() - e.v.y) / 2};
        Vec l = e.left, r = e.right();
        if (l.zero())
            l = -r;
        if (r.zero())
            r = -l;
        found.find(a, {e.v.x, e.v.y}, {l.x, l.y}, {r.x, r.y}, net.at(m)[c],
                   [&](ddt::scalar::Place p) { return tap(p.x, p.y); });
        std::copy(std::begin(found.null), std::end(found.null), to.null);
        std::copy(std::begin(found.shared), std::end(found.shared), to.shared);
        to.limit = fitted_bend_limit * found.range;
        const EdgeKind& k = scene.kinds[size_t(m)];
        ddt::scalar::find_shares(0.5f * (index[size_t(k.a)] + index[size_t(k.b)]), fitted_table(),
                                 to.share);
    });
}

} // namespace

bool make_scene(const std::string& file, int scale, bench::Light light, Scene& scene,
                std::string& error) {
    const DenormalsAreZero as_in_the_product;
    const FilterOptions options = filter_options();
    scene.name = file;
    scene.scale = scale;
    scene.light = light;
    if (!bench::read_original(file, scale, light, scene.original, error))
        return false;
    const metrics::Image small = bench::reduced(scene.original, scale, light, bench::Reduce::box);
    const std::vector<float> pixels = bench::pixels_of(small, light);
    Workspace workspace;
    Lattice& lattice = scene.lattice;
    make_mesh(pixels, small.width(), small.height(), light, options, workspace, lattice);
    find_kinds(scene, options.surface.soft);
    locate_samples(scene);

    ControlNet net;
    net.bounds = bounds_of(options.surface);
    test::set_all_vertices(lattice, {pixels.data(), colours, 0, colours}, net);
    test::WholeRounds consistency;
    consistency.begin(lattice, net, {options.surface.limit, true});
    test::WholeEdges edges;
    edges.make(lattice, {0, 0, lattice.width(), lattice.height()}, true, true, options.surface.soft,
               net);
    consistency.measure(lattice, Surface::patch, net);
    for (int c = 0; c < colours; ++c)
        find_features(scene, options.surface, net, consistency, c);
    return true;
}

} // namespace fit
