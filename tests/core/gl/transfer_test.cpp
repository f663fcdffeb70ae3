// SPDX-License-Identifier: Apache-2.0
// Sources whose numbers are codes, and sinks of 16-bit floats: fewer bytes, the same bits.
#include "core/gl/transfer.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>

#include "core/base/half.h"
#include "core/gl/buffer.h"
#include "core/gl/check/transfer_check.h"
#include "core/tiles/grid.h"
#include "ddt/log.h"
#include "tests/core/gl/devices.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// Codes of 8 or 16 bits, of all floats that they may stand for: those that 16 bits hold, with what
/// is not finite and what is almost nothing.
class CodeSource final : public Source {
public:
    CodeSource(int bits, int width, int channels)
        : m_bits(bits), m_width(width), m_channels(channels) {
        for (int i = 0; i < 1 << bits; ++i)
            m_table.push_back(bits == 16 ? float_of_half(uint16_t(i)) : std::ldexp(1.0f, i - 180));
    }
    bool read(const Rect& r, float* values, float* guide) override {
        ++reads;
        each(r, guide, [&](uint32_t code) { *values++ = m_table[code]; });
        return true;
    }
    std::vector<float> codes() override { return m_table; }
    bool read_codes(const Rect& r, void* codes, float* guide) override {
        auto* to = static_cast<char*>(codes);
        each(r, guide, [&](uint32_t code) {
            std::memcpy(to, &code, size_t(m_bits / 8));
            to += m_bits / 8;
        });
        return true;
    }

    std::atomic<int> reads{0}; ///< of floats

private:
    template <class F>
    void each(const Rect& r, float* guide, F&& put) const {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) {
                *guide++ = float((x / 7 + y / 5) % 3) * 0.25f;
                for (int c = 0; c < m_channels; ++c)
                    put((uint32_t((y * m_width + x) * m_channels + c) * 0x9e3779b9u >> 7) &
                        uint32_t(m_table.size() - 1));
            }
    }
    int m_bits, m_width, m_channels;
    std::vector<float> m_table;
};

/// A table of the codes of 255 x, rounded.
CodeTable rounding_table() {
    CodeTable table;
    table.shift = 14;
    const auto border = [](int code) { return bits_of(float((code - 0.5) / 255)); };
    const auto pieces_at = [&](uint32_t bits) { return bits >> table.shift; };
    table.first = pieces_at(border(1));
    table.lowest = float_of(table.first << table.shift);
    table.top = float_of(border(255));
    int code = 0;
    for (uint32_t piece = table.first; piece <= pieces_at(border(255)); ++piece) {
        const bool has_border = code < 255 && pieces_at(border(code + 1)) == piece;
        const uint32_t within = border(code + 1) & ((1u << table.shift) - 1);
        table.entries.push_back(uint32_t(code) << 24 | (has_border ? within : 0xffffffu));
        code += has_border;
    }
    return table;
}

/// Takes results packed as halfs or by a table; keeps their bytes.
class PackedSink final : public Sink {
public:
    PackedSink(const CodeTable* table, int width, int height, int channels)
        : m_table(table), m_row(size_t(width) * size_t(channels)), m_channels(size_t(channels)),
          bytes(m_row * size_t(height) * size(), 0xdd) {}
    bool write(const Rect& r, float* values) override {
        const size_t n = r.area() * m_channels;
        std::vector<uint8_t> packed(n * size());
        if (m_table)
            m_table->encode(values, packed.data(), n);
        for (size_t i = 0; !m_table && i < n; ++i) {
            const uint16_t half = half_of_float(values[i]);
            std::memcpy(&packed[2 * i], &half, 2);
        }
        put(r, packed.data());
        return true;
    }
    bool takes_halfs() const override { return !m_table; }
    const CodeTable* takes_codes() const override { return m_table; }
    bool write_packed(const Rect& r, const void* numbers) override {
        ++writes;
        put(r, static_cast<const uint8_t*>(numbers));
        return true;
    }

    std::atomic<int> writes{0}; ///< of what was packed before

private:
    size_t size() const { return m_table ? 1 : 2; }
    void put(const Rect& r, const uint8_t* packed) {
        const size_t n = size_t(r.width()) * m_channels * size();
        for (int y = r.y0; y < r.y1; ++y, packed += n)
            std::memcpy(&bytes[(size_t(y) * m_row + size_t(r.x0) * m_channels) * size()], packed,
                        n);
    }
    const CodeTable* m_table;
    size_t m_row, m_channels;

public:
    std::vector<uint8_t> bytes;
};

/// What a job said that it had moved.
struct Moved {
    double there = 0, back = 0; ///< megabytes
    int waits = 0;
};

class Transfer : public OnDevice {
protected:
    void TearDown() override {
        set_log({});
        gl::change_constant("", "", "");
        gl::forget_devices();
    }

    static ResizeMapping mapping(int width, int height) {
        return {ResizeMapping::Axis::whole(width, 2 * width),
                ResizeMapping::Axis::whole(height, 2 * height)};
    }

    /// Enlarge twofold; the device that did it.
    Device enlarged(Device device, Source& source, Sink& sink, Job job, Moved& moved) const {
        std::mutex mutex;
        set_log([&](const char* line) {
            const std::lock_guard<std::mutex> lock(mutex);
            std::sscanf(line, "ddt: %lf MB to the device, %lf MB from it, %d", &moved.there,
                        &moved.back, &moved.waits);
        });
        Statistics statistics;
        job.device = device;
        job.statistics = &statistics;
        std::string error;
        EXPECT_EQ(
            enlarge(source, sink, mapping(job.window.width(), job.window.height()), job, &error),
            Outcome::done)
            << error;
        set_log({});
        return statistics.device;
    }

    /// The same bits as the CPU's, by codes and halfs if so.
    void expect_same(int bits, const Job& job, bool small) const {
        const int width = job.window.width(), height = job.window.height();
        CodeSource source(bits, width, job.channels), here(bits, width, job.channels);
        const CodeTable table = rounding_table();
        for (const CodeTable* codes : {static_cast<const CodeTable*>(nullptr), &table}) {
            PackedSink sink(codes, 2 * width, 2 * height, job.channels),
                cpu(codes, 2 * width, 2 * height, job.channels);
            Moved moved;
            enlarged(Device::cpu, here, cpu, job, moved);
            EXPECT_EQ(enlarged(GetParam(), source, sink, job, moved), GetParam());
            EXPECT_EQ(sink.bytes, cpu.bytes) << bits << " bits, " << job.channels << " channels";
            EXPECT_EQ(source.reads == 0, small);
            EXPECT_EQ(sink.writes > 0, small);
        }
    }
};

Job job_of(int width, int height, int channels) {
    Job job = plain_job();
    job.window = {0, 0, width, height};
    job.channels = channels;
    return job;
}

Picture picture_of(Source& source, int width, int height, int channels) {
    const size_t pixels = size_t(width) * size_t(height);
    Picture p{width, height, channels, std::vector<float>(pixels * size_t(channels)),
              std::vector<float>(pixels)};
    source.read({0, 0, width, height}, p.values.data(), p.guide.data());
    return p;
}

TEST_P(Transfer, CodesThereAndHalfsBackAreTheCpusBits) {
    for (const int bits : {8, 16})
        for (const int channels : {1, 2, 3, 4, 5, 9})
            expect_same(bits, job_of(71, 53, channels), true);
}

TEST_P(Transfer, OfSeveralMeshesToo) {
    Job job = job_of(71, 53, 3);
    job.mesh.meshes = 3;
    job.mesh.blur = 0.1f;
    expect_same(16, job, true);
    job.mesh.scheme = Scheme::lawson; // whose mesh is the CPU's
    expect_same(8, job, true);
}

TEST_P(Transfer, IdsAndSinglePixelsTravelAsFloats) {
    Job job = job_of(71, 53, 4);
    job.kinds = {Channel::blend, Channel::nearest, Channel::blend, Channel::alpha};
    expect_same(8, job, false);
    CodeSource source(8, 1, 2);
    PackedSink sink(nullptr, 2, 80, 2);
    const Job thin = job_of(1, 40, 2);
    const auto transfer = gl::transfer_of(source, sink, thin);
    EXPECT_FALSE(transfer.upload.coded());
    EXPECT_EQ(transfer.download, gl::Transfer::Download::halfs);
}

TEST_P(Transfer, AnEmptyTableOfCodesIsNone) {
    const CodeTable empty;
    CodeSource source(8, 2, 1);
    const PackedSink sink(&empty, 2, 2, 1);
    const auto transfer = gl::transfer_of(source, sink, job_of(2, 2, 1));
    EXPECT_EQ(transfer.download_codes, nullptr);
    EXPECT_EQ(transfer.download, gl::Transfer::Download::floats);
}

TEST_P(Transfer, OtherNumbersOfCodesAreNone) {
    const Job plain = job_of(71, 53, 3);
    for (const int bits : {1, 7, 9, 15, 17}) {
        CodeSource source(bits, 71, 3);
        PackedSink sink(nullptr, 142, 106, 3);
        Moved moved;
        EXPECT_EQ(enlarged(GetParam(), source, sink, plain, moved), GetParam());
        EXPECT_GT(source.reads, 0) << bits;
    }
}

// Without pinned memory, as before OpenGL 4.4.
TEST_P(Transfer, WithoutPinnedMemoryToo) {
    gl::Functions& gl = fresh_device().context->gl;
    gl.BufferStorage = nullptr;
    expect_same(16, job_of(300, 270, 3), true);
}

// A tile of many channels may be larger than a storage block: several tiles are then not worked on
// at once, and one alone is the CPU's.
TEST_P(Transfer, NumbersFitStorageBlocks) {
    const int width = 300, height = 270, channels = 80;
    const size_t a_tile = 300 * 270 * channels * sizeof(float);
    const Job job = job_of(width, height, channels);
    for (const bool fits : {true, false}) {
        fresh_device().block_limit = fits ? a_tile + a_tile / 2 : a_tile - 4;
        CodeSource source(16, width, channels), here(16, width, channels);
        const Picture picture = picture_of(source, width, height, channels);
        BufferSource floats = source_of(picture);
        PackedSink sink(nullptr, 2 * width, 2 * height, channels),
            cpu(nullptr, 2 * width, 2 * height, channels);
        Moved moved;
        enlarged(Device::cpu, here, cpu, job, moved);
        EXPECT_EQ(enlarged(GetParam(), floats, sink, job, moved), fits ? GetParam() : Device::cpu);
        EXPECT_EQ(sink.bytes, cpu.bytes) << fits;
    }
}

TEST_P(Transfer, BytesAreThoseOfTheNumbers) {
    const int width = 600, height = 500, channels = 3; // the guides are a few steps
    // Of tiles with their halos: numbers, and a guide of two bytes.
    const Grid grid({0, 0, width, height});
    double pixels = 0;
    for (int i = 0; i < grid.count(); ++i)
        pixels += double(grid.tile(i).pixels.area());
    const double guides = pixels * 2, results = 4.0 * width * height * channels;
    const Job job = job_of(width, height, channels);
    for (const int bits : {8, 16}) {
        CodeSource source(bits, width, channels);
        const CodeTable table = rounding_table();
        PackedSink sink(bits == 8 ? &table : nullptr, 2 * width, 2 * height, channels);
        Moved moved;
        enlarged(GetParam(), source, sink, job, moved);
        EXPECT_NEAR(moved.there, (pixels * channels * bits / 8 + guides) * 1e-6, 0.06);
        EXPECT_NEAR(moved.back, results * bits / 8 * 1e-6, 0.06);
        // One for a batch, one for its strips, which are few enough to be written together.
        EXPECT_EQ(moved.waits, 2);
    }
    const Picture picture{width, height, channels,
                          std::vector<float>(size_t(width) * height * channels),
                          std::vector<float>(size_t(width) * height)};
    BufferSource source = source_of(picture);
    BitsSink sink(2 * width, 2 * height, channels);
    Moved moved;
    enlarged(GetParam(), source, sink, job, moved);
    EXPECT_NEAR(moved.there, (pixels * channels * 4 + guides) * 1e-6, 0.06);
    EXPECT_NEAR(moved.back, results * 4 * 1e-6, 0.06);
}

TEST_P(Transfer, AWrongProgramIsNotUsed) {
    const struct {
        const char *program, *name, *value;
    } changes[] = {{"unpack.comp CODES_8", "SURFACE_GROUP_X", "8"},
                   {"unpack.comp CODES_16", "SURFACE_GROUP_Y", "2"},
                   {"unpack.comp", "word", "0; ++slot"},
                   {"unpack_guide.comp", "steps", "7u"},
                   {"pack.comp HALFS", "small", "0u"},
                   {"pack.comp HALFS", "odd", "0u"},
                   {"pack.comp CODES", "is_nan", "false"},
                   {"pack.comp CODES", "within", "0u"}};
    const CodeTable table = rounding_table();
    using Download = gl::Transfer::Download;
    gl::Transfer all[] = {{},
                          {{1, std::vector<float>(256)}, Download::codes, &table},
                          {{2, std::vector<float>(65536)}, Download::halfs, nullptr}};
    for (gl::Transfer& transfer : all)
        for (size_t i = 0; i < transfer.upload.table.size(); ++i)
            transfer.upload.table[i] = float(i);
    for (const auto& change : changes) {
        gl::change_constant(change.program, change.name, change.value);
        gl::Gpu& gpu = fresh_device();
        int wrong = 0;
        for (const gl::Transfer& transfer : all)
            gpu.thread
                .post([&] {
                    const gl::FilledBuffers filled; // as where programs are checked
                    const bool differs = !gl::transfer_differs(gpu, transfer).empty();
                    wrong += differs;
                    EXPECT_TRUE(!differs || !gpu.checks.differs(gpu, Job(), transfer).empty());
                })
                .get();
        EXPECT_EQ(wrong, std::string(change.program) == "unpack_guide.comp" ? 3 : 1)
            << change.program << ' ' << change.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, Transfer, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test
