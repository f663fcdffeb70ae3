// SPDX-License-Identifier: Apache-2.0
#include "core/gl/work_on_gpu.h"

#include <algorithm>

#include "core/base/log.h"
#include "core/base/parallel.h"
#include "core/gl/budget.h"
#include "core/gl/context/failure.h"
#include "core/gl/guarded.h"
#include "core/gl/job_programs.h"
#include "core/gl/offload.h"
#include "core/gl/programs.h"
#include "core/surface/corrections.h"
#include "core/tiles/channel_groups.h"
#include "core/tiles/tile_io.h"

namespace ddt::gl {

namespace {

/// Bytes of output sampled in one go, about, and of all that is sampled and not written.
constexpr size_t strip_bytes = size_t(16) << 20, bytes_under_way = 4 * strip_bytes;

/// Rows that are handed to the sink at once.
constexpr int rows_a_write = 32;

/// Of a strip whose positions form a grid.
constexpr int most_columns = most_groups * sample_group_x, most_rows = most_groups * sample_group_y;

/// A strip of so many rows has no more than strip_bytes, if it can.
int strip_height(const Rect& reach, int channels) {
    const size_t row_bytes = size_t(reach.width()) * size_t(channels) * sizeof(float);
    return int(std::clamp<size_t>(strip_bytes / std::max<size_t>(row_bytes, 1), 1,
                                  size_t(std::clamp(reach.height(), 1, most_rows))));
}

/// How many strips of a job can be under way. Throws Failure where one cannot be sampled.
size_t most_strips(const Job& job, const Grid& grid, const Mapping& mapping) {
    constexpr size_t fewest = 3, most = 32;
    // Positions that are no grid are kept twice, as they are and on their way.
    const size_t positions = mapping.separable() ? 0 : 2 * 2 * sizeof(int32_t),
                 pixel_bytes = size_t(job.channels) * sizeof(float) + positions;
    size_t largest = 1;
    for (int i = 0; i < grid.count(); ++i) {
        const Rect reach = reach_of(grid.tile(i), job.window, mapping);
        if (mapping.separable() && reach.width() > most_columns)
            throw Failure("a tile becomes " + std::to_string(reach.width()) +
                          " pixels wide; allowed are " + std::to_string(most_columns));
        if (!reach.empty())
            largest = std::max(largest, size_t(strip_height(reach, job.channels)) *
                                            size_t(reach.width()) * pixel_bytes);
    }
    return std::clamp(bytes_under_way / largest, fewest, most);
}

} // namespace

Runner::Runner(Gpu& gpu, const TiledJob& tiled, Transfer transfer, JobState& state)
    : m_gpu(gpu), m_source(tiled.source), m_sink(tiled.sink), m_mapping(tiled.mapping),
      m_job(tiled.job), m_grid(tiled.grid), m_state(state), m_threads(tiled.threads),
      m_shape(shape_for(m_job.window)), m_meshes(m_job.mesh.meshes),
      m_transfer(std::move(transfer)),
      m_in_flight(affordable_tiles(gpu, m_shape, group_count(m_job.channels), m_job.mesh,
                                   m_job.surface, m_grid.count())),
      m_most_strips(most_strips(m_job, m_grid, m_mapping)), m_strips_a_write(m_most_strips / 3),
      m_strength(correction_strength(m_mapping.scale())),
      m_counting(m_job.statistics || verbose()) {}

Runner::~Runner() {
    m_gpu.thread.call([this] {
        drop_meshes();
        m_ready.clear();
        m_batch.clear();
        m_memory.clear();
        m_timer.reset();
    });
}

void Runner::work() {
    m_gpu.thread.post([this] { take_memory(); }).get();
    read_ahead();
    while (m_state.going() && !m_ready.empty()) {
        for (auto& tile : m_batch)
            m_memory.push_back(std::move(tile->memory));
        m_batch.clear();
        while (!m_ready.empty() && m_batch.size() < m_in_flight) {
            m_batch.push_back(std::move(m_ready.front()));
            m_ready.pop_front();
        }
        auto begun = m_gpu.thread.post([this] { begin_batch(); });
        // The results of the batch before are on their way meanwhile.
        read_ahead();
        write_strips(0);
        try {
            begun.get();
            m_gpu.thread.post([this] { finish_batch(); }).get();
            sample_batch();
        } catch (const OutOfMemory&) {
            if (m_in_flight == 1)
                throw;
            retry_with_fewer();
        }
    }
    write_strips(0);
    if (m_timer && m_timer->on())
        m_gpu.thread.post([this] { report(); }).wait();
}

/// Memory for the tiles of two batches: one is on its way to the device while the next is read.
void Runner::take_memory() {
    const size_t bytes = host_bytes(m_job, m_shape, m_transfer.upload);
    for (size_t i = 0; i < std::min(2 * m_in_flight, size_t(m_grid.count())); ++i)
        m_memory.push_back(std::make_unique<HostBuffer>(m_gpu.context->gl, bytes));
}

/// On the context's thread.
void Runner::drop_meshes() {
    m_surfaces.reset();
    m_mesh.reset();
    m_under_way.clear();
    m_spare.clear();
}

void Runner::retry_with_fewer() {
    m_gpu.thread.call([this] { drop_meshes(); });
    m_in_flight = (m_in_flight + 1) / 2;
    while (!m_batch.empty()) {
        m_ready.push_front(std::move(m_batch.back()));
        m_batch.pop_back();
    }
}

void Runner::read_ahead() {
    // Whatever is thrown here, tiles with memory are where ~Runner finds them: it is given back on
    // the context's thread.
    const size_t first = m_ready.size();
    while (m_next_tile < m_grid.count() && m_ready.size() < m_in_flight) {
        auto t = std::make_shared<JobTile>();
        t->index = m_next_tile++;
        t->tile = m_grid.tile(t->index);
        t->reach = reach_of(t->tile, m_job.window, m_mapping);
        if (t->reach.empty()) {
            m_state.tile_done(t->index);
            continue;
        }
        m_ready.push_back(t);
        if (!m_memory.empty()) {
            t->memory = std::move(m_memory.back());
            m_memory.pop_back();
        }
    }
    m_read_memory.resize(size_t(m_threads));
    for_each_index(m_threads, int(m_ready.size() - first), [&](int thread, int i) {
        JobTile& t = *m_ready[first + size_t(i)];
        if (m_state.going() &&
            !read(m_source, m_job, m_shape, m_transfer.upload, t, m_read_memory[size_t(thread)]))
            m_state.end(Outcome::source_failed);
    });
}

/// Ask the device for all it takes to sample the batch.
void Runner::begin_batch() {
    const Functions& gl = m_gpu.context->gl;
    if (!m_timer)
        m_timer = std::make_unique<StageTimer>(gl, verbose());
    if (!m_mesh || !m_surfaces) {
        const int slots = int(m_in_flight) * m_meshes;
        m_mesh = std::make_unique<DeviceMesh>(m_gpu, m_shape, slots);
        m_surfaces = std::make_unique<Surfaces>(m_gpu, m_shape, slots, kinds_of(m_job),
                                                m_job.surface, m_strength);
        m_surfaces->expect(m_transfer.upload, m_job.channels, m_meshes);
    }
    std::vector<TileSize> sizes;
    for (const auto& t : m_batch)
        sizes.insert(sizes.end(), size_t(m_meshes), t->size);

    m_timer->begin(Stage::upload);
    m_mesh->set_tiles(sizes);
    for (size_t i = 0; i < m_batch.size(); ++i)
        m_uploaded += upload(*m_batch[i], m_job, int(i) * m_meshes, *m_mesh, *m_surfaces);
    unpack(m_job, *m_mesh, *m_surfaces);
    m_timer->end();

    if (m_batch[0]->sites.empty()) {
        m_timer->begin(Stage::triangulate);
        m_mesh->triangulate(m_job.mesh);
        m_timer->end();
    }
    m_timer->begin(Stage::surface);
    m_surfaces->make(*m_mesh, criterion(m_job.mesh));
    m_timer->end();
    gl.Flush();
    // Else another job on this thread would come upon the error, and this one not.
    check(gl, "triangulation");
}

/// Wait for it: what fails is told of here, and the batch's memory is free.
void Runner::finish_batch() {
    ++m_waits;
    finish(m_gpu.context->gl, "triangulation");
    if (!m_counting || !m_batch[0]->sites.empty())
        return;
    const auto done = m_mesh->read_statistics();
    for (size_t slot = 0; slot < done.size(); ++slot) {
        JobTile& t = *m_batch[slot / size_t(m_meshes)];
        if (slot % size_t(m_meshes) == 0)
            t.statistics = {};
        t.statistics.pixels += int64_t(t.size.width) * t.size.height;
        t.statistics += done[slot];
    }
}

void Runner::sample_batch() {
    for (size_t i = 0; i < m_batch.size() && m_state.going(); ++i) {
        const JobTile& t = *m_batch[i];
        const int height = strip_height(t.reach, m_job.channels);
        for (int y = std::max(t.reach.y0, m_state.next_row(t.index));
             y < t.reach.y1 && m_state.going(); y += height) {
            JobStrip& strip = next_strip();
            strip.tile = m_batch[i];
            strip.rows = {t.reach.x0, y, t.reach.x1, std::min(y + height, t.reach.y1)};
            strip.last = strip.rows.y1 == t.reach.y1;
            plan_strip(m_mapping, t.tile, int(i) * m_meshes, strip);
            strip.plan.meshes = m_meshes;
            strip.sampled = m_gpu.thread.post([this, &strip] { sample(strip); }).share();
        }
    }
    // Whether all could be asked for must be known while the batch can be done again.
    for (const auto& strip : m_under_way)
        strip->sampled.get();
}

/// The newest under way, whose memory may have been another's.
Runner::JobStrip& Runner::next_strip() {
    if (m_under_way.size() >= m_most_strips)
        write_strips(m_most_strips - m_strips_a_write);
    if (m_spare.empty())
        m_spare.push_back(std::make_unique<JobStrip>());
    m_under_way.push_back(std::move(m_spare.back()));
    m_spare.pop_back();
    return *m_under_way.back();
}

void Runner::make_room(JobStrip& strip) {
    m_surfaces->make_room(strip.positions.size(), result_count(strip), m_transfer, strip.memory);
    const size_t bytes =
        strip.memory.results->bytes() / sizeof(float) * m_transfer.download_bytes();
    if (strip.results && strip.results->bytes() >= bytes)
        return;
    strip.results.reset();
    strip.results = std::make_unique<HostBuffer>(m_gpu.context->gl, bytes);
}

/// Ask the device for the strip's results.
void Runner::sample(JobStrip& strip) {
    const Functions& gl = m_gpu.context->gl;
    make_room(strip);
    if (strip.plan.count > 0) {
        m_timer->begin(Stage::sample);
        m_surfaces->write_positions(strip.positions, strip.memory);
        m_surfaces->sample(*m_mesh, strip.plan, strip.memory);
        m_timer->end();
        m_timer->begin(Stage::download);
        m_downloaded +=
            m_surfaces->download(result_count(strip), m_transfer, strip.memory, *strip.results);
        m_timer->end();
        check(gl, "sampling");
    }
    strip.copied = std::make_unique<Fence>(gl);
}

/// Write what is under way, the oldest first, until no more than `left` strips are.
void Runner::write_strips(size_t left) {
    while (m_under_way.size() > left) {
        const size_t count = std::min(m_under_way.size() - left, m_strips_a_write);
        for (size_t i = 0; i < count; ++i)
            m_under_way[i]->sampled.get();
        // What is asked for first is there first.
        m_gpu.thread
            .post([&] {
                ++m_waits;
                m_under_way[count - 1]->copied->wait("sampling");
            })
            .get();
        if (m_state.going())
            write(count);
        for (size_t i = 0; i < count; ++i) {
            m_under_way.front()->tile.reset();
            m_spare.push_back(std::move(m_under_way.front()));
            m_under_way.pop_front();
        }
    }
}

/// Write the oldest strips, all of them at once: one tile's is not much for many threads.
void Runner::write(size_t count) {
    std::vector<std::pair<Rect, std::byte*>> parts;
    for (size_t i = 0; i < count; ++i) {
        const JobStrip& strip = *m_under_way[i];
        std::byte* numbers = strip.results ? strip.results->data() : nullptr;
        for (const Rect& run : strip.runs)
            for (int y = run.y0; y < run.y1; y += rows_a_write) {
                const Rect part{run.x0, y, run.x1, std::min(y + rows_a_write, run.y1)};
                parts.emplace_back(part, numbers);
                numbers += part.area() * size_t(m_job.channels) * m_transfer.download_bytes();
            }
    }
    for_each_index(m_threads, int(parts.size()), [&](int, int i) {
        const auto& [part, first] = parts[size_t(i)];
        if (!m_state.going())
            return;
        const bool taken = m_transfer.packed()
                               ? m_sink.write_packed(part, first)
                               : m_sink.write(part, reinterpret_cast<float*>(first));
        if (!taken)
            m_state.end(Outcome::sink_failed);
    });
    for (size_t i = 0; i < count; ++i)
        wrote(*m_under_way[i]);
}

void Runner::wrote(const JobStrip& strip) {
    const JobTile& t = *strip.tile;
    m_state.wrote_rows_before(strip.rows.y1, t.index);
    if (!strip.last || !m_state.going())
        return;
    m_state.tile_done(t.index);
    m_statistics += t.statistics;
}

void Runner::report() {
    const auto ms = [&](Stage stage) { return m_timer->milliseconds(stage); };
    say("ddt: %.1f MB to the device, %.1f MB from it, %d waits for it", double(m_uploaded) * 1e-6,
        double(m_downloaded) * 1e-6, m_waits);
    say("ddt: upload %.2f ms, triangulate %.2f ms, surface %.2f ms, sample %.2f ms, "
        "download %.2f ms; opened in %.0f ms, %d shaders compiled in %.0f ms, checked in "
        "%.0f ms",
        ms(Stage::upload), ms(Stage::triangulate), ms(Stage::surface), ms(Stage::sample),
        ms(Stage::download), m_gpu.open_milliseconds, m_gpu.programs->begun(),
        m_gpu.programs->milliseconds(), m_gpu.checks.milliseconds());
}

} // namespace ddt::gl

namespace ddt {

std::string work_on_gpu(gl::Gpu& gpu, const TiledJob& tiled, JobState& state,
                        Statistics& statistics) {
    return gl::guarded_on(gpu, [&]() -> std::string {
        const Job& job = tiled.job;
        gl::Transfer transfer = gl::transfer_of(tiled.source, tiled.sink, job);
        const auto begin = [&] {
            for (const gl::JobProgram& program : gl::job_programs(job, transfer))
                gpu.programs->expect(program.file, program.macros);
            return gpu.checks.differs(gpu, job, transfer);
        };
        if (std::string difference = gpu.thread.post(begin).get(); !difference.empty())
            return difference;
        gl::Runner runner(gpu, tiled, std::move(transfer), state);
        try {
            runner.work();
        } catch (...) {
            statistics += runner.statistics();
            throw;
        }
        statistics += runner.statistics();
        return {};
    });
}

} // namespace ddt
