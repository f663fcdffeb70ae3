// SPDX-License-Identifier: Apache-2.0
#include "core/gl/check/tin_check.h"

#include <cstring>
#include <vector>

#include "core/base/float_mode.h"
#include "core/gl/check/difference.h"
#include "core/gl/context/failure.h"
#include "core/gl/device_tin.h"
#include "core/gl/gpu.h"
#include "core/tin/tin_mesh.h"
#include "core/triangulate/gain.h"
#include "ddt/names.h"

namespace ddt::gl {

namespace {

constexpr int width = 19, height = 15, step = 1 << 20;

/// Iterations after which nothing is left to flip, so that no gain is stale.
constexpr int enough = 32;

using Words = std::vector<uint32_t>;

uint32_t hash(uint32_t x) {
    x = (x ^ (x >> 15)) * 0x2c1b3c6du;
    x = (x ^ (x >> 12)) * 0x297a2d39u;
    return x ^ (x >> 15);
}

/// A grid whose points are moved about, two triangles a cell, with stripes and noise.
Tin make_tin() {
    Tin tin;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const uint32_t h = hash(uint32_t(y * width + x + 1));
            const float stripe = (2 * x + 3 * y) % 17 < 7 ? 0.6f : 0.0f;
            tin.vertices.push_back(
                {{x * step + int(h % (step * 2 / 5)), y * step + int((h >> 11) % (step * 2 / 5))},
                 stripe + float(h >> 20) * (0.3f / 4096)});
        }
    std::vector<std::array<int32_t, 3>> triangles;
    for (int32_t y = 0; y + 1 < height; ++y)
        for (int32_t x = 0; x + 1 < width; ++x) {
            const int32_t v = y * width + x;
            triangles.push_back({v, v + 1, v + width});
            triangles.push_back({v + 1, v + width + 1, v + width});
        }
    std::string error;
    if (!connect(tin, triangles, error))
        throw Failure(error);
    return tin;
}

/// What is compared.
struct TinOutcomes {
    Words triangles, faces, gains, counts;
};

template <class Record>
Words words_of(const std::vector<Record>& records) {
    Words words(records.size() * sizeof(Record) / sizeof(uint32_t));
    std::memcpy(words.data(), records.data(), words.size() * sizeof(uint32_t));
    return words;
}
/// Whatever a zero's sign.
Words words_of(std::vector<float> numbers) {
    for (float& x : numbers)
        x = x + 0.0f;
    return words_of<float>(numbers);
}
Words words_of(const Statistics& s) {
    return {uint32_t(s.evaluations), uint32_t(s.flips), uint32_t(s.rounds), uint32_t(s.iterations)};
}

/// As floats, of which a zero's sign does not count.
Words words_of(const std::vector<TinFace>& faces) {
    std::vector<float> numbers(faces.size() * 4);
    std::memcpy(numbers.data(), faces.data(), numbers.size() * sizeof(float));
    return words_of(std::move(numbers));
}

TinOutcomes on_cpu(Tin tin, const MeshOptions& options) {
    const DenormalsAreZero as_on_gpus;
    Statistics statistics;
    Workspace workspace;
    triangulate(tin, options, workspace, statistics);
    TinOutcomes o;
    o.triangles = words_of(tin.triangles);
    o.counts = words_of(statistics);
    TinMesh mesh(tin, options.cost);
    std::vector<TinFace> faces;
    for (size_t t = 0; t < tin.triangles.size(); ++t)
        faces.push_back(mesh.face(int(t)));
    o.faces = words_of(faces);
    std::vector<int> flippable;
    for (size_t m = 0; m < mesh.size(); ++m)
        if (mesh.flippable(int(m)))
            flippable.push_back(int(m));
    find_gains(mesh, criterion(options), flippable.data(), flippable.size());
    std::vector<float> all;
    for (size_t m = 0; m < mesh.size(); ++m)
        all.push_back(mesh.gain(int(m)));
    o.gains = words_of(std::move(all));
    return o;
}

TinOutcomes on_gpu(Gpu& gpu, Tin tin, const MeshOptions& options) {
    Statistics statistics;
    DeviceTin device(gpu, tin);
    device.triangulate(options, Workspace(), statistics);
    device.read(tin);
    TinOutcomes o;
    o.triangles = words_of(tin.triangles);
    o.counts = words_of(statistics);
    std::vector<TinFace> faces(tin.triangles.size());
    std::vector<float> gains(tin.edges.size());
    device.read_work(faces, gains);
    o.faces = words_of(faces);
    o.gains = words_of(std::move(gains));
    return o;
}

} // namespace

std::string tin_key_of(const MeshOptions& options) {
    return std::string(options.scheme == Scheme::annealing ? "annealed " : "") + "points " +
           cost_name(options.cost);
}

std::string tin_differs_from_cpu(Gpu& gpu, const MeshOptions& options) {
    const Tin tin = make_tin();
    const bool chance = options.scheme == Scheme::annealing;
    for (const Scheme scheme :
         {Scheme::exproi_n_maxgain, chance ? Scheme::annealing : Scheme::basic}) {
        MeshOptions check;
        check.cost = options.cost;
        check.scheme = scheme;
        check.min_gain = -1.0f;
        check.max_iterations = enough;
        check.contour = 0;
        const TinOutcomes cpu = on_cpu(tin, check);
        TinOutcomes device;
        std::string what;
        try {
            device = on_gpu(gpu, tin, check);
            what = difference("numbers of triangles", cpu.triangles, device.triangles);
        } catch (const DoesNotEnd& e) {
            what = e.what();
        }
        if (what.empty())
            what = difference("numbers of gradients", cpu.faces, device.faces);
        if (what.empty())
            what = difference("numbers of gains", cpu.gains, device.gains);
        if (what.empty())
            what = difference("numbers of counts", cpu.counts, device.counts);
        if (!what.empty())
            return difference_of(gpu.context->renderer, tin_key_of(options), what);
    }
    return {};
}

} // namespace ddt::gl
