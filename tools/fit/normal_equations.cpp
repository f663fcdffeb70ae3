// SPDX-License-Identifier: Apache-2.0
#include "tools/fit/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fit {

using namespace ddt;

namespace {

constexpr int first_bound = int(offsetof(FittedWeights, bound) / sizeof(float));
constexpr int first_shared = int(offsetof(FittedWeights, shared) / sizeof(float));
constexpr int first_null = int(offsetof(FittedWeights, null) / sizeof(float));

int first_of(int length, int kind, int node) {
    return first_null + ((length * fitted_kinds + kind) * fitted_nodes + node) * fitted_edge_null;
}

/// What a pixel of the original is made of, in the surface's own numbers.
struct Parts {
    struct Vertex {
        int site;
        float count;
    };
    Vertex vertices[15]; ///< a site may be there several times
    int vertex_count = 0;
    struct {
        int site;
        float count;
    } edges[3];

    Parts(const Scene& scene, const Sample& s) {
        for (int k = 0; k < 3; ++k)
            add(s.vertex[k], s.b[k]);
        for (int k = 0; k < 3; ++k) {
            const float bi = s.b[k], bj = s.b[(k + 1) % 3];
            edges[k] = {s.edge[k], bi * bj};
            const EdgeKind& e = scene.kinds[size_t(s.edge[k])];
            const float q = std::min(bi, bj) * e.softness;
            if (q == 0)
                continue;
            add(e.c, q);
            add(e.d, q);
            add(e.a, -q);
            add(e.b, -q);
        }
    }
    void add(int site, float count) {
        if (count != 0)
            vertices[vertex_count++] = {site, count};
    }
};

/// A row of the equations: most of it is 0.
struct Row {
    double value[unknowns] = {};
    bool there[unknowns] = {};
    int used[unknowns];
    int count = 0;

    void add(int first, const float* f, int n, float times) {
        if (times == 0)
            return;
        for (int i = first; i < first + n; ++i, ++f) {
            if (!there[i]) {
                there[i] = true;
                used[count++] = i;
            }
            value[i] += double(*f) * double(times);
        }
    }
    void clear() {
        for (int i = 0; i < count; ++i)
            value[used[i]] = 0, there[used[i]] = false;
        count = 0;
    }
};

/// The sample's row; returns the surface's value without weights.
double fill(const Scene& scene, const Features& features, const Sample& s, Row& row) {
    const Parts parts(scene, s);
    double value = 0;
    for (int i = 0; i < parts.vertex_count; ++i) {
        const Features::Vertex& v = features.vertices[size_t(parts.vertices[i].site)];
        value += double(parts.vertices[i].count) * double(v.z);
        for (int k = 0; k < fitted_nodes && v.moves; ++k) {
            const float count = parts.vertices[i].count * v.share[k];
            row.add(k * fitted_vertex_features, v.f, fitted_vertex_features, count);
            row.add(first_bound + k * fitted_vertex_features, v.f, fitted_vertex_features,
                    count * v.bound);
        }
    }
    for (const auto& edge : parts.edges) {
        const Features::Edge& e = features.edges[size_t(edge.site)];
        const EdgeKind& kind = scene.kinds[size_t(edge.site)];
        for (int k = 0; k < fitted_nodes; ++k) {
            const float count = edge.count * e.share[k];
            row.add(first_shared + k * fitted_edge_shared, e.shared, fitted_edge_shared, count);
            row.add(first_of(kind.length, kind.kind, k), e.null, fitted_edge_null, count);
            row.add(first_of(kind.length, 2, k), e.null, fitted_edge_null, count * kind.near);
        }
    }
    return value;
}

/// Whether what the weights make of a row is cut off to the display value.
bool is_truncated(const Row& row, double value, double display, const FittedWeights& weights) {
    const float* w = &weights.vertex[0][0];
    for (int i = 0; i < row.count; ++i)
        value += row.value[row.used[i]] * double(w[row.used[i]]);
    return (display <= 0.5 && value <= 0) || (display >= 254.5 && value >= 1);
}

/// How much faster the display value grows than the light at v, 0 to 1 each.
double steepness(double display, bench::Light light) {
    if (light == bench::Light::encoded)
        return 1;
    const double v = display / 255;
    return v <= 0.04045 ? 12.92 : 1.055 / 2.4 * std::pow((v + 0.055) / 1.055, 1 - 2.4);
}

} // namespace

void NormalEquations::add(const NormalEquations& other) {
    for (size_t i = 0; i < matrix.size(); ++i)
        matrix[i] += other.matrix[i];
    for (size_t i = 0; i < right.size(); ++i)
        right[i] += other.right[i];
}

void NormalEquations::add(const Scene& scene, double weight, unsigned every, uint32_t seed,
                          const FittedWeights* so_far) {
    NormalEquations sum;
    Row row;
    double error = 0;
    size_t count = 0;
    const int border = scene.scale, width = scene.original.width();
    for (int c = 0; c < 3; ++c)
        for (int y = border; y < scene.original.height() - border; ++y)
            for (int x = border; x < width - border; ++x) {
                seed = seed * 1664525u + 1013904223u;
                if ((seed >> 8) % every != 0)
                    continue;
                const double display = scene.original.channels[c].at(x, y);
                const double value =
                    fill(scene, scene.features[c],
                         scene.samples[size_t(y) * size_t(width) + size_t(x)], row);
                const double steep = steepness(display, scene.light);
                const double wanted = (bench::decode(display, scene.light) - value) * steep;
                error += wanted * wanted;
                ++count;
                if (so_far && is_truncated(row, value, display, *so_far)) {
                    row.clear();
                    continue;
                }
                std::sort(row.used, row.used + row.count);
                for (int i = 0; i < row.count; ++i) {
                    const int p = row.used[i];
                    const double f = row.value[p] * steep;
                    sum.right[size_t(p)] += f * wanted;
                    double* to = &sum.matrix[size_t(p) * unknowns];
                    const double twice = f * steep;
                    for (int j = 0; j <= i; ++j)
                        to[row.used[j]] += twice * row.value[row.used[j]];
                }
                row.clear();
            }
    if (count == 0)
        return;
    const double scale = weight / (error + 1e-5 * double(count));
    for (double& v : sum.matrix)
        v *= scale;
    for (double& v : sum.right)
        v *= scale;
    add(sum);
}

void NormalEquations::solve(const std::vector<int>& wanted, double ridge, float* weights) const {
    const size_t n = wanted.size();
    const auto at = [&](int i, int j) {
        return matrix[size_t(std::max(i, j)) * unknowns + size_t(std::min(i, j))];
    };
    std::vector<double> a(n * n), x(n);
    double trace = 0;
    for (size_t i = 0; i < n; ++i) {
        x[i] = right[size_t(wanted[i])];
        for (int j = 0; j < unknowns; ++j)
            if (!std::binary_search(wanted.begin(), wanted.end(), j))
                x[i] -= at(wanted[i], j) * double(weights[j]);
        for (size_t j = 0; j <= i; ++j)
            a[i * n + j] = at(wanted[i], wanted[j]);
        trace += a[i * n + i];
    }
    for (size_t i = 0; i < n; ++i)
        a[i * n + i] += ridge * a[i * n + i] + 1e-12 * trace;
    // Cholesky's factors of the lower half, then both triangles.
    for (size_t j = 0; j < n; ++j) {
        for (size_t i = j; i < n; ++i)
            for (size_t k = 0; k < j; ++k)
                a[i * n + j] -= a[i * n + k] * a[j * n + k];
        const double root = std::sqrt(a[j * n + j]);
        for (size_t i = j; i < n; ++i)
            a[i * n + j] /= root;
    }
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 0; k < i; ++k)
            x[i] -= a[i * n + k] * x[k];
        x[i] /= a[i * n + i];
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; ++k)
            x[i] -= a[k * n + i] * x[k];
        x[i] /= a[i * n + i];
        weights[wanted[i]] = float(x[i]);
    }
}

void NormalEquations::solve_plain(double ridge, FittedWeights& weights) const {
    weights = {};
    std::vector<int> wanted;
    for (int i = 0; i < unknowns; ++i)
        if (i < first_bound || i >= first_shared)
            wanted.push_back(i);
    solve(wanted, ridge, &weights.vertex[0][0]);
}

void NormalEquations::solve_bound(double ridge, FittedWeights& weights) const {
    std::vector<int> wanted;
    for (int i = first_bound; i < first_shared; ++i)
        wanted.push_back(i);
    solve(wanted, ridge, &weights.vertex[0][0]);
}

metrics::Image enlarge(const Scene& scene, const FittedWeights& weights) {
    metrics::Image image = scene.original;
    const float* w = &weights.vertex[0][0];
    for (int c = 0; c < 3; ++c) {
        const Features& features = scene.features[c];
        std::vector<float> net(features.vertices.size());
        const auto dot = [&](int first, const float* f, int n) {
            float sum = 0;
            for (int i = 0; i < n; ++i)
                sum += w[first + i] * f[i];
            return sum;
        };
        for (int y = 0; y < scene.lattice.height(); ++y)
            for (int x = 0; x < scene.lattice.width(); ++x) {
                const auto site = size_t(scene.lattice.vertex_site(x, y));
                const Features::Vertex& v = features.vertices[site];
                float z = v.z;
                for (int k = 0; k < fitted_nodes && v.moves; ++k) {
                    const int n = fitted_vertex_features, first = k * n;
                    z += v.share[k] *
                         (dot(first, v.f, n) + v.bound * dot(first_bound + first, v.f, n));
                }
                net[site] = std::clamp(z, v.low, v.high);
            }
        scene.lattice.each_edge([&](int m) {
            const Features::Edge& e = features.edges[size_t(m)];
            const EdgeKind& kind = scene.kinds[size_t(m)];
            float bend = 0;
            for (int k = 0; k < fitted_nodes; ++k)
                bend += e.share[k] *
                        (dot(first_shared + k * fitted_edge_shared, e.shared, fitted_edge_shared) +
                         dot(first_of(kind.length, kind.kind, k), e.null, fitted_edge_null) +
                         kind.near * dot(first_of(kind.length, 2, k), e.null, fitted_edge_null));
            net[size_t(m)] = std::clamp(bend, -e.limit, e.limit);
        });
        for (size_t i = 0; i < scene.samples.size(); ++i) {
            const Parts parts(scene, scene.samples[i]);
            float value = 0;
            for (int k = 0; k < parts.vertex_count; ++k)
                value += parts.vertices[k].count * net[size_t(parts.vertices[k].site)];
            for (const auto& edge : parts.edges)
                value += edge.count * net[size_t(edge.site)];
            image.channels[c].values[i] = bench::encode(double(value), scene.light);
        }
    }
    return image;
}

} // namespace fit
