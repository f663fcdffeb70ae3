// SPDX-License-Identifier: Apache-2.0
#include "tests/core/gl/stages/compare_stages.h"

#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/base/float_bits.h"
#include "core/guide/guide.h"
#include "core/tiles/tile_io.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/gl/stages/gpu_stages.h"

namespace ddt::test {

namespace {

/// A gain, gradient or bend counts as the same if its value is: what is made of it does not see a
/// zero's sign.
bool same_value(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

class Comparison {
public:
    Comparison(gl::Gpu& gpu, const Picture& picture, const Job& job)
        : m_picture(picture), m_job(job), m_source(source_of(picture)), m_gpu(gpu, m_source, job) {
        const Tile tile = Grid(job.window).tile(0);
        read_tile(m_source, tile, job, m_values, m_guide, m_width, m_height);
        if (const float share = blur_share(job.mesh, 0); share > 0)
            blur_guide(m_guide.data(), m_width, m_height, share);
    }

    std::vector<StageResult> run() {
        if (gl::DeviceMesh::knows(m_job.mesh))
            compare_meshes();
        const bool bend = m_job.surface.kind != Surface::linear;
        for (int round = 0; round <= m_job.surface.consistency; ++round)
            compare_surfaces(round, bend);
        compare_results();
        return std::move(m_results);
    }

private:
    StageResult& begin(const std::string& name, const char* what) {
        m_results.push_back({name, what, 0, 0, 0, 0, 0, 0, 0});
        return m_results.back();
    }
    static void count(StageResult& r, bool same, int x, int y, int channel, uint32_t cpu,
                      uint32_t gpu) {
        ++r.compared;
        if (same)
            return;
        if (r.differing++ > 0)
            return;
        r.x = x;
        r.y = y;
        r.channel = channel;
        r.cpu = cpu;
        r.gpu = gpu;
    }
    /// Call f(x, y, site) for every edge.
    template <class F>
    void each_edge(F&& f) const {
        for (int y = 0; y < 2 * m_height - 1; ++y)
            for (int x = 1 - (y & 1), step = 2 - (y & 1); x < 2 * m_width - 1; x += step)
                f(x, y, size_t(y) * size_t(2 * m_width) + size_t(x));
    }

    bool compare_mesh(const std::string& name, const MeshStage& cpu, const MeshStage& gpu) {
        StageResult& edges = begin(name, "edges");
        each_edge([&](int x, int y, size_t m) {
            const uint64_t a = cpu.sites[m], b = gpu.sites[m];
            const int word = uint32_t(a) == uint32_t(b) ? 32 : 0;
            count(edges, a == b, x, y, 0, uint32_t(a >> word), uint32_t(b >> word));
        });
        return edges.differing == 0;
    }
    void compare_gains(const std::string& name, const MeshStage& cpu, const MeshStage& gpu) {
        StageResult& gains = begin(name, "gains");
        each_edge([&](int x, int y, size_t m) {
            count(gains, same_value(cpu.gains[m], gpu.gains[m]), x, y, 0, bits_of(cpu.gains[m]),
                  bits_of(gpu.gains[m]));
        });
    }

    void compare_meshes() {
        const auto on_cpu = [&](const MeshOptions& options, int iterations) {
            return cpu_mesh(m_guide, m_width, m_height, options, iterations);
        };
        const MeshStage start = on_cpu(m_job.mesh, 0);
        MeshStage gpu = m_gpu.mesh(m_job.mesh, 0, true);
        compare_mesh("starting mesh", start, gpu);
        compare_gains("starting mesh, found alone", start, gpu);
        if (m_job.mesh.scheme == Scheme::pixel)
            return;
        MeshOptions still = m_job.mesh;
        still.min_gain = 1e30f; // nothing flips, and the start's gains remain
        if (still.scheme == Scheme::annealing)
            still.scheme = Scheme::one_round; // annealing flips by chance what gains nothing
        compare_gains("starting mesh", start, m_gpu.mesh(still, 1, false));
        MeshStage before = start;
        for (int i = 1; i <= m_job.mesh.max_iterations; ++i) {
            const MeshStage cpu = on_cpu(m_job.mesh, i);
            gpu = m_gpu.mesh(m_job.mesh, i, false);
            const std::string name = "after iteration " + std::to_string(i);
            const bool same = compare_mesh(name, cpu, gpu);
            compare_gains(name, cpu, gpu);
            const bool flipped = before.sites != cpu.sites;
            if (!flipped || !same)
                break;
            before = cpu;
        }
    }

    void compare_at_pixels(const std::string& name, const char* what, const std::vector<float>& cpu,
                           const std::vector<float>& gpu, size_t numbers, bool exact) {
        StageResult& r = begin(name, what);
        for (size_t i = 0; i < cpu.size(); ++i) {
            const int pixel = int(i / numbers), number = int(i % numbers);
            const bool same =
                exact ? bits_of(cpu[i]) == bits_of(gpu[i]) : same_value(cpu[i], gpu[i]);
            count(r, same, pixel % m_width, pixel / m_width, number % group_size, bits_of(cpu[i]),
                  bits_of(gpu[i]));
        }
    }
    void compare_at_edges(const std::string& name, const char* what, const std::vector<float>& cpu,
                          const std::vector<float>& gpu) {
        StageResult& r = begin(name, what);
        each_edge([&](int x, int y, size_t m) {
            for (size_t i = m * group_size; i < (m + 1) * group_size; ++i)
                count(r, same_value(cpu[i], gpu[i]), x, y, int(i % group_size), bits_of(cpu[i]),
                      bits_of(gpu[i]));
        });
    }

    void compare_surfaces(int rounds, bool bend) {
        const SurfaceStage cpu = cpu_surface(m_guide, m_values, m_width, m_height, m_job, rounds);
        const SurfaceStage gpu = m_gpu.surface(rounds);
        const std::string name =
            rounds == 0 ? "surface" : "surface after " + std::to_string(rounds) + " corrections";
        compare_at_pixels(name, "vertices", cpu.vertices, gpu.vertices, group_size, true);
        if (bend) {
            compare_at_pixels(name, "gradients", cpu.gradients, gpu.gradients, 2 * group_size,
                              false);
            compare_at_edges(name, "bends", cpu.bends, gpu.bends);
        }
        if (m_job.surface.soft > 0)
            compare_at_edges(name, "softness", cpu.softness, gpu.softness);
    }

    void compare_results() {
        Order order;
        order.job = m_job;
        order.out_width = 2 * m_picture.width;
        order.out_height = 2 * m_picture.height;
        const Result cpu = enlarge_on(Device::cpu, m_picture, order);
        const std::vector<float> gpu = m_gpu.result(order.out_width, order.out_height);
        StageResult& r = begin("result", "samples");
        for (size_t i = 0; i < gpu.size(); ++i) {
            const int pixel = int(i / size_t(m_job.channels));
            count(r, cpu.bits[i] == bits_of(gpu[i]), pixel % order.out_width,
                  pixel / order.out_width, int(i % size_t(m_job.channels)), cpu.bits[i],
                  bits_of(gpu[i]));
        }
    }

    const Picture& m_picture;
    const Job& m_job;
    BufferSource m_source;
    GpuStages m_gpu;
    std::vector<float> m_values, m_guide;
    int m_width = 0, m_height = 0;
    std::vector<StageResult> m_results;
};

} // namespace

std::vector<StageResult> compare_stages(gl::Gpu& gpu, const Picture& picture, const Job& wanted) {
    Job job = wanted;
    job.window = {0, 0, picture.width, picture.height};
    job.channels = picture.channels;
    job.mesh.meshes = 1;
    return gpu.thread.post([&] { return Comparison(gpu, picture, job).run(); }).get();
}

std::string line_of(const StageResult& r) {
    char line[160];
    int n = std::snprintf(line, sizeof line, "%-32s %-10s %8zu ", r.name.c_str(), r.what.c_str(),
                          r.compared);
    const auto rest = [&] { return sizeof line - size_t(n); };
    if (r.differing == 0)
        std::snprintf(line + n, rest(), "the same");
    else
        std::snprintf(line + n, rest(), "%zu differ, first at %d, %d, channel %d: %08x, not %08x",
                      r.differing, r.x, r.y, r.channel, r.gpu, r.cpu);
    return line;
}

} // namespace ddt::test
