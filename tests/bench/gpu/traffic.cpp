// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/gpu/traffic.h"

#include <algorithm>

#include "core/gl/programs.h"
#include "core/surface/corrections.h"

namespace ddt::bench {

namespace {

// Bytes a pixel: its guide, its cell's contour word, four sites, their gains, RGBA and its
// gradients, its index, its three edges' bends or their softness.
constexpr double guide = 4, contour_word = 4, sites = 32, gains = 16, values = 16,
                 two_gradients = 32, index = values, of_edges = 3 * values;
// Bytes of an entry: of a list of edges, of the list of those that wait.
constexpr double entry = 4, waiting_entry = 8;

/// Pixels of a tile not more than so many edges off those it serves.
double needed(const gl::TileSize& t, const gl::Reach& reach, int edges) {
    const auto far = [&](uint32_t side) { return edges * int(side); };
    const int x0 = std::max(t.served_x0 - far(reach.left), 0),
              y0 = std::max(t.served_y0 - far(reach.upper), 0),
              x1 = std::min(t.served_x1 + far(reach.right), t.width - 1),
              y1 = std::min(t.served_y1 + far(reach.lower), t.height - 1);
    return double(x1 - x0 + 1) * double(y1 - y0 + 1);
}

} // namespace

void add_tile(const gl::TileSize& tile, double positions, const gl::Reach& reach,
              const SurfaceOptions& surface, Workload& work) {
    work.pixels += double(tile.width) * tile.height;
    work.served += needed(tile, reach, 0);
    work.out += positions;
    // The margins of Surfaces::make and fit.
    if (is_fitted(surface)) {
        work.gradients += needed(tile, reach, 3);
        work.edges += needed(tile, reach, 3);
        work.corrections += needed(tile, reach, 2);
        work.bends += needed(tile, reach, 1);
        return;
    }
    if (surface.kind != Surface::linear)
        work.gradients += needed(tile, reach, 1);
    for (int later = 0; later < surface.consistency; ++later) {
        const double corrected = needed(tile, reach, 2 + 2 * later);
        const double before = needed(tile, reach, 3 + 2 * later);
        if (surface.kind != Surface::linear)
            work.gradients += before;
        if (surface.kind != Surface::linear || surface.soft > 0)
            work.edges += before;
        work.corrections += corrected;
        if (later + 1 < surface.consistency)
            work.later_corrections += corrected;
    }
}

int finish_passes(const std::vector<gl::IterationCounts>& tile) {
    const auto passes = [](uint32_t entries) {
        return int((entries + gl::finish_group - 1) / gl::finish_group);
    };
    int sum = 0;
    for (size_t i = gl::dispatched_iterations + 1; i < tile.size(); ++i)
        sum += passes(tile[i].dirty) + passes(tile[i].candidates + tile[i - 1].blocked) +
               passes(tile[i].selected);
    return sum;
}

namespace {

/// The iterations of one_round().
void add_iterations(const Workload& w, double contour_words_an_edge,
                    std::map<std::string, double>& bytes) {
    const double all_sites = w.pixels * sites, all_gains = w.pixels * gains;
    double waiting = 0, dirty = 0;
    for (size_t i = 0; i < w.iterations.size(); ++i) {
        const gl::IterationCounts& c = w.iterations[i];
        const auto kernel = [&](const char* name) -> double& {
            return bytes[int(i) < gl::dispatched_iterations ? name : "finish.comp"];
        };
        if (i > 0)
            // The edge and four about it, eight guides, the words of two cells.
            kernel("evaluate.comp") +=
                dirty * entry + std::min(dirty * (40 + 32), all_sites) +
                std::min(dirty * contour_words_an_edge * contour_word, w.pixels * contour_word) +
                std::min(dirty * 4, all_gains) + c.candidates * entry;
        else
            bytes["start.comp"] += c.candidates * entry;
        // The edge and four about it, its gain and twelve; stamps of what waits, and for whom.
        kernel("select.comp") +=
            c.candidates * entry + std::min(double(c.candidates) * 40, all_sites) +
            std::min(double(c.candidates) * 13 * 4, all_gains) + waiting * (waiting_entry + 8) +
            c.selected * entry + c.blocked * waiting_entry;
        dirty = i + 1 < w.iterations.size() ? w.iterations[i + 1].dirty : 0;
        waiting = c.blocked;
        // Thirteen edges, whose second word is written, the first of five too, and a word of four
        // vertices.
        kernel("flip.comp") +=
            c.selected * entry +
            std::min(double(c.selected) * (13 * 8 + 13 * 4 + 5 * 4 + 4 * 4), 2 * all_sites) +
            dirty * entry;
    }
}

void add_surface(const Workload& w, const SurfaceOptions& surface,
                 std::map<std::string, double>& bytes) {
    const bool fitted = is_fitted(surface);
    const double soft = surface.soft > 0 ? gains : 0,
                 gradients = surface.kind != Surface::linear ? two_gradients : 0;
    const double net = sites + values + soft;
    if (w.gradients > 0)
        bytes["gradients.comp"] = w.gradients * (sites + values + two_gradients);
    // Indices are made where vertices are corrected.
    if (fitted)
        bytes["gradients.comp"] += w.corrections * index;
    const double edges =
        (surface.kind != Surface::linear ? of_edges : 0) + (surface.soft > 0 ? of_edges : 0);
    if (w.edges > 0)
        bytes["net_edges.comp"] = w.edges * (net + gradients + edges);
    // Only later rounds read the source beside values that are no longer the same.
    if (w.corrections > 0)
        bytes["correct.comp"] =
            w.corrections * (sites + values + edges + values + (fitted ? index : 0)) +
            w.later_corrections * values;
    if (w.bends > 0)
        bytes["fitted_bends.comp"] =
            w.bends * (sites + values + gains + of_edges + index + of_edges);
    bytes["sample.comp"] = w.served * (net + (fitted ? of_edges : gradients)) + w.out * values;
}

} // namespace

std::map<std::string, double> traffic(const Workload& w, const MeshOptions& mesh,
                                      const SurfaceOptions& surface) {
    std::map<std::string, double> bytes;
    const bool contours = mesh.contour != 0, iterates = mesh.max_iterations > 0;
    const bool one_round = mesh.scheme == Scheme::one_round && iterates;
    const bool annealing = mesh.scheme == Scheme::annealing && iterates;
    const double words = contours ? contour_word : 0;
    // Floats as they travelled, and 16-bit steps of the guide.
    bytes["unpack.comp"] = w.pixels * 2 * values;
    bytes["unpack_guide.comp"] = w.pixels * (guide / 2 + guide);
    if (contours)
        bytes["contours.comp"] = w.pixels * (guide + contour_word);
    bytes["start.comp"] =
        w.pixels * (guide + words + sites + (iterates && mesh.scheme != Scheme::pixel ? gains : 0));
    if (one_round)
        add_iterations(w, contours ? 2 : 0, bytes);
    // DeviceMesh::find_gains.
    else if (!annealing && (surface.soft > 0 || is_fitted(surface)))
        bytes["evaluate.comp"] = w.pixels * (sites + gains + words);
    add_surface(w, surface, bytes);
    return bytes;
}

} // namespace ddt::bench
