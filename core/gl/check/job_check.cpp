// SPDX-License-Identifier: Apache-2.0
#include "core/gl/check/job_check.h"

#include <climits>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>

#include "core/base/arith.h"
#include "core/base/float_bits.h"
#include "core/base/float_mode.h"
#include "core/gl/budget.h"
#include "core/gl/check/difference.h"
#include "core/gl/gpu.h"
#include "core/gl/host_tile.h"
#include "core/gl/strip.h"
#include "core/guide/guide.h"
#include "core/surface/corrections.h"
#include "core/tiles/tile_io.h"
#include "core/tiles/tile_worker.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/schemes.h"
#include "core/triangulate/triangulate.h"
#include "ddt/names.h"

namespace ddt::gl {

namespace {

/// A tile within its picture, whose slots are larger, and serves some of its cells. Its size and
/// that of its results are no multiples of groups of invocations.
constexpr Rect window{-3, -2, 65, 50};
constexpr Tile checked_tile{{6, 5, 56, 42}, {0, 0, 63, 49}, false, false};
constexpr int scale = 3;
/// Tiles on the device, all the same.
constexpr int copies = 2;
using Bits = std::vector<uint32_t>;

/// Noise, stripes and a few very bright pixels; in a corner of what is served, so that most of the
/// check is of numbers as pictures have them, also what is not finite, or is so large that sums of
/// it are not; beside that rows so steep that sums of their gradients are denormal; pixels from
/// black to white; and ones so alike that it is not their smallest that bounds how far below them a
/// corrected vertex may go. The guide has stripes of its own.
class CheckSource final : public Source {
public:
    explicit CheckSource(int channels) : m_channels(channels) {}
    bool read(const Rect& r, float* values, float* guide) override {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) {
                const uint32_t h = hash(uint32_t(x), uint32_t(y));
                const float noise = noise_of(h), stripe = stripe_at(x, y);
                const float bright = h % 101 == 0 ? 1000.0f : 1.0f;
                *guide++ = guide_at(x, y);
                const bool odd = x < 18 && y < 15 && h % 4 == 0;
                const bool steep = x >= 20 && x < 38 && y < 15;
                const bool smooth = x >= 7 && x < 22 && y >= 24 && y < 39;
                const float usual =
                    smooth ? 0.7f + 0.02f * noise : (0.3f * noise + stripe) * bright;
                for (int c = 0; c < m_channels; ++c)
                    *values++ = odd     ? odd_number(h / 4 + uint32_t(c))
                                : steep ? (y % 2 != 0 ? 0x1p46f : 0x1p-79f * (1 + noise))
                                : between_stripes(x, y)
                                    ? float(hash(h, uint32_t(c)) >> 8) * 0x1p-24f
                                    : usual * float(c + 1) * 0.37f;
            }
        return true;
    }

private:
    /// Of multiples of guide_unit from 0 to 1 squares are exact in most places, and a sum of them
    /// has the same bits where a device contracts it: some contrasts are neither.
    static float guide_at(int x, int y) {
        if (y > repeated)
            y = repeated + (y - repeated) % 2;
        const uint32_t h = hash(uint32_t(x), uint32_t(y));
        if (between_stripes(x, y))
            return (x % 7 < 3 ? 0.5f : 0.25f) + float(h >> 30) * guide_unit;
        return (0.5f * noise_of(h) + stripe_at(x, y)) * (h % 7 == 0 ? 11.3f : 1.0f);
    }
    /// Here the guide's stripes are upright, so that contours tell of no diagonal which way it
    /// goes: its ends do, which differ by little. Values go from black to white, for what fitted
    /// vertices make of pixels near both.
    static bool between_stripes(int x, int y) { return x >= 24 && x < 48 && y >= 22 && y < 40; }
    /// The guide's rows after this one are it and the next by turns: there edges have the gains of
    /// others near them, and which of them flips is a matter of their places.
    static constexpr int repeated = 40;
    static float noise_of(uint32_t h) { return float(h >> 20) * (1.0f / 4096.0f); }
    static float stripe_at(int x, int y) { return (2 * x + 3 * y) % 29 < 11 ? 0.5f : 0.0f; }
    static float odd_number(uint32_t i) {
        constexpr float infinity = std::numeric_limits<float>::infinity(), large = 3e38f;
        constexpr float reciprocal_squared_is_denormal = 5e36f;
        constexpr float all[] = {
            std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -0.0f, large, -large,
            reciprocal_squared_is_denormal,          -0.8f,    -30.0f};
        return all[i % std::size(all)];
    }
    static uint32_t hash(uint32_t x, uint32_t y) {
        uint32_t h = x * 0x9e3779b9u ^ y * 0x85ebca6bu;
        h = (h ^ (h >> 15)) * 0x2c1b3c6du;
        h = (h ^ (h >> 12)) * 0x297a2d39u;
        return h ^ (h >> 15);
    }
    int m_channels;
};

/// Keeps what is written of a part of the result.
class CheckSink final : public Sink {
public:
    CheckSink(const Rect& part, int channels)
        : m_part(part), m_channels(size_t(channels)), m_bits(part.area() * m_channels) {}
    bool write(const Rect& r, float* values) override {
        const size_t row = size_t(r.width()) * m_channels;
        for (int y = r.y0; y < r.y1; ++y, values += row)
            std::memcpy(&m_bits[index_of(r.x0, y)], values, row * sizeof(float));
        return true;
    }
    /// What was written to these pixels, one rectangle after the other.
    Bits of(const std::vector<Rect>& runs) const {
        Bits all;
        for (const Rect& r : runs)
            for (int y = r.y0; y < r.y1; ++y)
                all.insert(all.end(), m_bits.begin() + ptrdiff_t(index_of(r.x0, y)),
                           m_bits.begin() + ptrdiff_t(index_of(r.x1 - 1, y) + m_channels));
        return all;
    }

private:
    size_t index_of(int x, int y) const {
        return (size_t(y - m_part.y0) * size_t(m_part.width()) + size_t(x - m_part.x0)) *
               m_channels;
    }
    Rect m_part;
    size_t m_channels;
    Bits m_bits;
};

ResizeMapping enlarged() {
    const auto axis = [](int window0, int window1) {
        const int n = window1 - window0;
        return ResizeMapping::Axis{window0, n, 0, scale * n, window0, window1, 0, scale * n};
    };
    return {axis(window.x0, window.x1), axis(window.y0, window.y1)};
}

/// Neither mapping enlarges by that; both tell it, so that the correction's strength is no power of
/// two, by which contracted products would have the same bits.
constexpr Mapping::Scale told_scale{1.9, 1.95};

class Enlarged final : public Mapping {
public:
    Rect reach(double x0, double y0, double x1, double y1) const override {
        return m_mapping.reach(x0, y0, x1, y1);
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        m_mapping.row(y, x0, x1, positions, inside);
    }
    bool separable() const override { return true; }
    Scale scale() const override { return told_scale; }

private:
    ResizeMapping m_mapping = enlarged();
};

/// Positions that form no grid, among them those of cells that the tile does not serve.
class Turned final : public Mapping {
public:
    Rect reach(double, double, double, double) const override { return {0, 0, 101, 83}; }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        constexpr int one = position_one;
        for (int x = x0; x < x1; ++x) {
            const Position p{14 * one + 31337 * x - 10007 * y, 10007 * x + 31337 * y};
            *inside++ = p.x >= window.x0 * one && p.x <= (window.x1 - 1) * one &&
                        p.y >= window.y0 * one && p.y <= (window.y1 - 1) * one;
            *positions++ = p;
        }
    }
    Scale scale() const override { return told_scale; }
};

/// What is compared: of the first mesh its edges' vectors and gains, in the order of addresses, and
/// the job's result by Enlarged and by Turned.
struct Outcomes {
    std::vector<uint64_t> edges;
    Bits gains;
    CheckSink large, turned;
};

uint32_t bits_of_gain(float gain) {
    return bits_of(gain + 0.0f); // whatever a zero's sign
}

/// Call f with the site of each edge of a device's mesh, whose rows are `stride` long.
template <class F>
void each_edge(int stride, const F& f) {
    const int columns = 2 * checked_tile.pixels.width() - 1;
    const int rows = 2 * checked_tile.pixels.height() - 1;
    for (int y = 0; y < rows; ++y)
        for (int x = 1 - (y & 1), step = 2 - (y & 1); x < columns; x += step)
            f(size_t(y) * size_t(stride) + size_t(x));
}

CheckSink result_of(const Job& job, const Mapping& mapping) {
    CheckSource source(job.channels);
    CheckSink sink(reach_of(checked_tile, window, mapping), job.channels);
    TileWorker(source, sink, mapping, job).work(checked_tile, INT_MIN);
    return sink;
}

Outcomes on_cpu(const Job& job) {
    Outcomes o{{}, {}, result_of(job, Enlarged()), result_of(job, Turned())};
    const Tile& tile = checked_tile;
    CheckSource source(job.channels);
    std::vector<float> values, guide;
    int w = 0, h = 0;
    read_tile(source, tile, job, values, guide, w, h);
    if (const float share = blur_share(job.mesh, 0); share > 0)
        blur_guide(guide.data(), w, h, share);
    {
        const DenormalsAreZero as_on_gpus;
        Lattice lattice;
        Workspace workspace;
        workspace.origin_x = tile.pixels.x0 - window.x0;
        workspace.origin_y = tile.pixels.y0 - window.y0;
        Statistics statistics;
        start(lattice, w, h, guide.data(), job.mesh);
        triangulate(lattice, job.mesh, workspace, statistics);
        find_all_gains(lattice, criterion(job.mesh));
        lattice.each_edge([&](int m) {
            o.edges.push_back(vectors_of(lattice.edge(m)));
            o.gains.push_back(bits_of_gain(lattice.gain(m)));
        });
    }
    return o;
}

/// What the device makes of the mesh in a slot, compared.
std::string mesh_differs(DeviceMesh& mesh, int slot, const Job& job, const Outcomes& cpu) {
    const SlotShape& shape = mesh.shape();
    std::vector<uint64_t> sites(shape.sites()), edges;
    mesh.read_sites(slot, sites.data());
    each_edge(shape.stride(), [&](size_t m) { edges.push_back(sites[m] & vectors_mask); });
    const std::string what = difference("edges", cpu.edges, edges);
    if (!what.empty())
        return what;
    mesh.find_gains(criterion(job.mesh));
    std::vector<float> of_sites(shape.sites());
    Bits gains;
    mesh.read_gains(slot, of_sites.data());
    each_edge(shape.stride(), [&](size_t m) { gains.push_back(bits_of_gain(of_sites[m])); });
    return difference("gains", cpu.gains, gains);
}

/// What the device shows of the tile in a slot, compared.
std::string result_differs(const Functions& gl, DeviceMesh& mesh, Surfaces& surfaces, int slot,
                           const Job& job, const Mapping& mapping, const CheckSink& cpu) {
    Strip strip;
    strip.rows = reach_of(checked_tile, window, mapping);
    plan_strip(mapping, checked_tile, slot, strip);
    strip.plan.meshes = job.mesh.meshes;
    const size_t count = size_t(strip.plan.count) * size_t(job.channels);
    SampleMemory memory;
    HostBuffer results(gl, count * sizeof(float));
    surfaces.make_room(strip.positions.size(), count, Transfer(), memory);
    surfaces.write_positions(strip.positions, memory);
    surfaces.sample(mesh, strip.plan, memory);
    surfaces.download(count, Transfer(), memory, results);
    finish(gl, "self-check");
    Bits bits(count);
    std::memcpy(bits.data(), results.data(), count * sizeof(float));
    return difference("numbers", cpu.of(strip.runs), bits);
}

/// Do the job on the device; what differs first.
std::string differs(Gpu& gpu, const Job& job, const Outcomes& cpu) {
    const Functions& gl = gpu.context->gl;
    CheckSource source(job.channels);
    const SlotShape shape = shape_for(job.window);
    const int meshes = job.mesh.meshes, slots = copies * meshes, last = slots - meshes;
    HostTile t;
    t.tile = checked_tile;
    const Numbers numbers;
    t.memory = std::make_unique<HostBuffer>(gl, host_bytes(job, shape, numbers));
    ReadMemory memory;
    read(source, job, shape, numbers, t, memory);
    DeviceMesh mesh(gpu, shape, slots);
    mesh.finish_after(2, 2); // so that each of one_round's programs flips edges
    mesh.pause_after(2000);  // and accept_reject.comp goes on from where it was
    Surfaces surfaces(gpu, shape, slots, kinds_of(job), job.surface,
                      correction_strength(told_scale));
    surfaces.expect(numbers, job.channels, meshes);
    mesh.set_tiles(std::vector<TileSize>(size_t(slots), t.size));
    for (int slot = 0; slot < slots; slot += meshes)
        upload(t, job, slot, mesh, surfaces);
    unpack(job, mesh, surfaces);
    if (t.sites.empty())
        mesh.triangulate(job.mesh);
    // Programs that follow the edges of a spoilt mesh may not come to an end.
    for (const int slot : {0, last})
        if (const std::string what = mesh_differs(mesh, slot, job, cpu); !what.empty())
            return what;
    surfaces.make(mesh, criterion(job.mesh));
    const std::string what = result_differs(gl, mesh, surfaces, last, job, Enlarged(), cpu.large);
    return what.empty() ? result_differs(gl, mesh, surfaces, 0, job, Turned(), cpu.turned) : what;
}

/// Which branches of accept_reject.comp they take.
std::string key_of(const Rules& rules) {
    return std::string("accept_reject") + (rules.by_gain ? " by gain" : "") +
           (rules.wide_iterations == 0               ? ""
            : rules.wide_iterations >= Rules::always ? " wide"
                                                     : " wide at first");
}

std::string scheme_key_of(const MeshOptions& mesh) {
    const std::optional<Rules> rules = find_rules(mesh);
    return !DeviceMesh::knows(mesh)           ? "mesh of the CPU"
           : mesh.scheme == Scheme::pixel     ? "pixel"
           : rules                            ? key_of(*rules)
           : mesh.scheme == Scheme::annealing ? "annealing"
                                              : "one_round";
}

/// The job that is checked in place of `job`. `clipped` and `start` are the job's own: where others
/// differ in them alone, each is checked.
Job job_to_check(const Job& job) {
    Job check;
    check.window = window;
    check.channels = job.channels % group_size == 0 ? group_size : group_size + 1;
    check.kinds.assign(size_t(check.channels), Channel::blend);
    check.kinds[2] = Channel::nearest;
    check.kinds[3] = Channel::alpha;
    check.mesh.scheme = job.mesh.scheme;
    check.mesh.cost = job.mesh.cost;
    check.mesh.start = job.mesh.start;
    check.mesh.contour = job.mesh.contour > 0 ? 0.4f : 0.0f;
    if (job.mesh.scheme == Scheme::annealing)
        check.mesh.max_iterations = 6;
    if (job.mesh.max_iterations == 0)
        check.mesh.max_iterations = 0;
    check.mesh.min_gain = -1.0f; // many flips, and late ones
    check.mesh.blur = 0.07f;     // several meshes differ by it
    // What is right for two meshes counts for more of them (job_key_of), yet of two surfaces the
    // mean is of halves, which are exact: contracted it has the same bits; of three it has others.
    check.mesh.meshes = job.mesh.meshes > 1 ? 3 : 1;
    check.surface.kind = job.surface.kind;
    check.surface.consistency = std::min(job.surface.consistency, 2);
    check.surface.limit = 0.3f; // its default is a power of two, products with which are exact
    check.surface.soft = job.surface.soft > 0 ? 0.3f : 0.0f;
    check.surface.fitted = job.surface.fitted;
    check.surface.clipped = job.surface.clipped;
    return check;
}

} // namespace

std::string job_differs_from_cpu(Gpu& gpu, const Job& wanted) {
    const Job job = job_to_check(wanted);
    return difference_of(gpu.context->renderer, job_key_of(wanted), differs(gpu, job, on_cpu(job)));
}

std::string job_key_of(const Job& job) {
    const MeshOptions& mesh = job.mesh;
    std::string key = scheme_key_of(mesh) + ' ' + cost_name(mesh.cost);
    key += mesh.start != Start::flat && DeviceMesh::knows(mesh) ? " diagonal" : "";
    key += mesh.max_iterations == 0 ? " still" : "";
    key += mesh.contour > 0 ? " contour" : "";
    key += job.surface.kind == Surface::linear ? " linear" : " patch";
    key += job.surface.soft > 0 ? " soft" : "";
    key += job.surface.consistency > 0 ? " consistency" : "";
    key += is_fitted(job.surface) ? " fitted" : "";
    key += job.surface.consistency > 0 && job.surface.clipped ? " clipped" : "";
    key += mesh.meshes > 1 ? " meshes" : "";
    return key + (job.channels % group_size == 0 ? " whole groups" : "");
}

} // namespace ddt::gl
