// SPDX-License-Identifier: Apache-2.0
// A static object whose constructor enlarges, and so does its destructor.
#include <algorithm>
#include <atomic>
#include <cstdlib>

#include <gtest/gtest.h>

#include "ddt/core.h"

namespace {

constexpr ddt::Rect window{0, 0, 300, 300};

class Flat final : public ddt::Source {
public:
    bool read(const ddt::Rect& r, float* values, float* guide) override {
        std::fill_n(values, r.area(), 0.5f);
        std::fill_n(guide, r.area(), 0.5f);
        return true;
    }
};

class Counting final : public ddt::Sink {
public:
    bool write(const ddt::Rect& r, float*) override {
        written += r.area();
        return true;
    }
    std::atomic<size_t> written{0};
};

/// Twice as large, on the device that a job is given unless somebody says otherwise. Returns how
/// many pixels were written.
size_t enlarge() {
    unsetenv("DDT_DEVICE");
    ddt::ResizeMapping::Axis axis;
    axis.from_size = axis.window1 = window.width();
    axis.to_size = axis.out1 = 2 * window.width();
    ddt::Job job;
    job.window = window;
    Flat source;
    Counting sink;
    const ddt::Outcome outcome = ddt::enlarge(source, sink, ddt::ResizeMapping(axis, axis), job);
    return outcome == ddt::Outcome::done ? sink.written.load() : 0;
}

constexpr size_t all = size_t(600) * 600;

struct Enlarging {
    size_t written = enlarge();
    ~Enlarging() {
        if (enlarge() != all)
            std::_Exit(1);
    }
} enlarging;

TEST(StaticObject, EnlargesInItsConstructorAndItsDestructor) {
    EXPECT_EQ(enlarging.written, all);
}

} // namespace
