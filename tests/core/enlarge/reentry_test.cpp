// SPDX-License-Identifier: Apache-2.0
// User code that uses oneTBB itself: while it waits for its own tasks, its thread must not take up
// another tile, whose worker is the one in use.
#include <atomic>
#include <chrono>
#include <thread>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

/// Calls of user code within other calls of it on the same thread.
std::atomic<int> nested{0};
thread_local int depth = 0;

/// Work for oneTBB that takes its thread a while, with tasks for others to steal.
void use_tbb() {
    nested += depth++ > 0;
    std::atomic<int64_t> sum{0};
    tbb::parallel_for(0, 64, [&](int i) {
        // Whoever has done its share waits for the others, and might look for other work.
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        sum += i;
    });
    EXPECT_GT(sum, 0);
    --depth;
}

class UsingSource final : public Source {
public:
    explicit UsingSource(Source& source) : m_source(source) {}
    bool read(const Rect& r, float* values, float* guide) override {
        use_tbb();
        return m_source.read(r, values, guide);
    }

private:
    Source& m_source;
};

class UsingSink final : public Sink {
public:
    explicit UsingSink(Sink& sink) : m_sink(sink) {}
    bool write(const Rect& r, float* values) override {
        use_tbb();
        return m_sink.write(r, values);
    }

private:
    Sink& m_sink;
};

class UsingMapping final : public Mapping {
public:
    explicit UsingMapping(const Mapping& mapping) : m_mapping(mapping) {}
    Rect reach(double x0, double y0, double x1, double y1) const override {
        use_tbb();
        return m_mapping.reach(x0, y0, x1, y1);
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        if (y % 16 == 0)
            use_tbb();
        m_mapping.row(y, x0, x1, positions, inside);
    }
    bool separable() const override { return m_mapping.separable(); }

private:
    const Mapping& m_mapping;
};

TEST(Reentry, UserCodeMayUseTheSameThreadPool) {
    // More threads than this machine may have cores.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 8);
    const Rect window{0, 0, 2600, 1300}, out{0, 0, 2600, 1302}; // 66 tiles
    TestSource source(window, 1, 3, Kind::noise);
    const ResizeMapping mapping = mapping_of(window, out, out);
    Job job = job_of(source, 1);
    job.device = Device::cpu;
    job.mesh.scheme = Scheme::pixel;
    TestSink plain(out, 1), sink(out, 1);
    ASSERT_EQ(enlarge(source, plain, mapping, job), Outcome::done);

    nested = 0;
    job.threads = 8;
    int calls = 0;
    job.progress = [&](float) {
        use_tbb();
        ++calls;
        return true;
    };
    UsingSource using_source(source);
    UsingSink using_sink(sink);
    ASSERT_EQ(enlarge(using_source, using_sink, UsingMapping(mapping), job), Outcome::done);
    EXPECT_EQ(nested, 0);
    EXPECT_GT(calls, 30);
    EXPECT_EQ(sink.written(1), int64_t(out.area()));
    EXPECT_EQ(differing(plain.values(), sink.values()), 0u);
}

} // namespace
} // namespace ddt::test
