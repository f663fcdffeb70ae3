// SPDX-License-Identifier: Apache-2.0
#include "core/gl/self_check.h"

#include <climits>
#include <cstring>

#include "core/gl/budget.h"
#include "core/gl/strip.h"
#include "core/tiles/tile_worker.h"

namespace ddt::gl {

namespace {

constexpr int width = 64, height = 48, channels = 4, scale = 3;
using Bits = std::vector<uint32_t>;

/// Noise, stripes and a few very bright pixels.
class CheckSource final : public Source {
public:
    bool read(const Rect& r, float* values, float* guide) override {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) {
                const uint32_t h = hash(uint32_t(x), uint32_t(y));
                const float noise = float(h >> 20) * (1.0f / 4096.0f);
                const float stripe = (2 * x + 3 * y) % 29 < 11 ? 0.5f : 0.0f;
                const float bright = h % 101 == 0 ? 1000.0f : 1.0f;
                *guide++ = 0.5f * noise + stripe;
                for (int c = 0; c < channels; ++c)
                    *values++ = (0.3f * noise + stripe) * bright * float(c + 1) * 0.37f;
            }
        return true;
    }

private:
    static uint32_t hash(uint32_t x, uint32_t y) {
        uint32_t h = x * 0x9e3779b9u ^ y * 0x85ebca6bu;
        h = (h ^ (h >> 15)) * 0x2c1b3c6du;
        h = (h ^ (h >> 12)) * 0x297a2d39u;
        return h ^ (h >> 15);
    }
};

class CheckSink final : public Sink {
public:
    bool write(const Rect& r, float* values) override {
        for (int y = r.y0; y < r.y1; ++y, values += r.width() * channels)
            std::memcpy(&bits[(size_t(y) * width * scale + size_t(r.x0)) * channels], values,
                        size_t(r.width()) * channels * sizeof(float));
        return true;
    }
    Bits bits = Bits(size_t(width * scale) * size_t(height * scale) * channels);
};

Job check_job() {
    Job job;
    job.window = {0, 0, width, height};
    job.channels = channels;
    return job;
}

ResizeMapping check_mapping() {
    const auto axis = [](int n) {
        ResizeMapping::Axis a;
        a.from_size = a.window1 = n;
        a.to_size = a.out1 = scale * n;
        return a;
    };
    return {axis(width), axis(height)};
}

Bits on_cpu(const Job& job, const Tile& tile) {
    CheckSource source;
    CheckSink sink;
    const ResizeMapping mapping = check_mapping();
    TileWorker(source, sink, mapping, job).work(tile, INT_MIN);
    return sink.bits;
}

Bits on_gpu(Gpu& gpu, const Job& job, const Tile& tile) {
    CheckSource source;
    std::vector<float> values(size_t(width * height) * channels), guide(size_t(width * height));
    source.read(job.window, values.data(), guide.data());
    const SlotShape shape = shape_for(job.window);
    DeviceMesh mesh(gpu, shape, 1);
    Surfaces surfaces(gpu, shape, 1, std::vector<GroupKinds>(1), job.surface);
    mesh.set_tiles({size_in_slot(tile, width, height)});
    mesh.write_guide(0, guide.data());
    surfaces.write_values(0, 0, values.data());
    mesh.triangulate(job.mesh);
    surfaces.make(mesh, job.mesh.cost);
    Strip strip;
    strip.rows = {0, 0, width * scale, height * scale};
    plan_strip(check_mapping(), tile, 0, strip);
    surfaces.write_positions(strip.positions);
    surfaces.sample(mesh, strip.plan, channels);
    Bits bits(size_t(strip.plan.count) * channels);
    surfaces.read_result(bits.size() * sizeof(uint32_t), bits.data());
    finish(gpu.context->gl, "self-check");
    return bits;
}

} // namespace

std::string differs_from_cpu(Gpu& gpu) {
    const Job job = check_job();
    const Tile tile = Grid(job.window).tile(0);
    const Bits cpu = on_cpu(job, tile), device = on_gpu(gpu, job, tile);
    size_t differing = 0;
    for (size_t i = 0; i < cpu.size(); ++i)
        differing += cpu[i] != device[i];
    if (differing == 0)
        return {};
    return gpu.context->renderer +
           " does not compute as the CPU does: " + std::to_string(differing) + " of " +
           std::to_string(cpu.size()) + " numbers differ";
}

} // namespace ddt::gl
