// SPDX-License-Identifier: Apache-2.0
// What follows when something fails: the right picture, or the right error.
#include "core/gl/context/faults.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"

namespace ddt::test {
namespace {

using gl::Fault;

class Faults : public OnDevice {
protected:
    void SetUp() override {
        gl::forget_devices();
        OnDevice::SetUp();
        gl::forget_devices();
    }
    void TearDown() override {
        for (int f = 0; f < int(Fault::count); ++f)
            gl::arm(Fault(f), 0);
        gl::forget_devices();
    }

    Picture picture = make_picture(Content::photo, 600, 40, 4, 1);
    Order order = make_order();

    static Order make_order() {
        Order o;
        o.out_width = 1300;
        o.out_height = 90;
        o.job.surface.consistency = 1;
        return o;
    }

    /// Another source in place of the picture.
    Outcome enlarged_from(Source& source) const {
        BitsSink sink(order.out_width, order.out_height, picture.channels);
        Job job = order.job;
        job.window = {0, 0, picture.width, picture.height};
        job.channels = picture.channels;
        job.device = GetParam();
        const ResizeMapping mapping(ResizeMapping::Axis::whole(picture.width, order.out_width),
                                    ResizeMapping::Axis::whole(picture.height, order.out_height));
        return enlarge(source, sink, mapping, job);
    }

    /// The picture must be right, and each pixel written once, whatever happened.
    void expect_right(const Result& result, Device device, const std::string& what) {
        const Result cpu = enlarge_on(Device::cpu, picture, order);
        EXPECT_EQ(result.outcome, Outcome::done) << what << ": " << result.error;
        EXPECT_EQ(result.bits, cpu.bits) << what;
        EXPECT_EQ(result.times, cpu.times) << what;
        EXPECT_EQ(result.statistics.device, device) << what;
    }
};

TEST_P(Faults, AMissingLibraryIsNamed) {
    gl::arm(Fault::library, 1, 1000);
    const Result result = enlarge_on(GetParam(), picture, order);
    EXPECT_EQ(result.outcome, Outcome::device_unavailable);
    EXPECT_NE(result.error.find(GetParam() == Device::egl ? "libEGL.so.1" : "libOSMesa.so.8"),
              std::string::npos)
        << result.error;
}

TEST_P(Faults, ARefusedContextIsNamedWithItsVersion) {
    gl::arm(Fault::context, 1, 1000);
    const Result result = enlarge_on(GetParam(), picture, order);
    EXPECT_EQ(result.outcome, Outcome::device_unavailable);
    EXPECT_NE(result.error.find("CreateContext"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("4.3"), std::string::npos) << result.error;
}

TEST_P(Faults, AShaderThatDoesNotCompileLeavesTheWorkToTheCpu) {
    gl::arm(Fault::shader, 0);
    expect_right(enlarge_on(GetParam(), picture, order), GetParam(), "no fault");
    const int shaders = gl::chances(Fault::shader);
    EXPECT_GT(shaders, 5);
    for (int n = 1; n <= shaders; ++n) {
        gl::forget_devices();
        gl::arm(Fault::shader, n);
        expect_right(enlarge_on(GetParam(), picture, order), Device::cpu,
                     "shader " + std::to_string(n));
    }
}

TEST_P(Faults, AFailedAllocationIsTriedAgainWithFewerTiles) {
    gl::arm(Fault::allocation, 0);
    expect_right(enlarge_on(GetParam(), picture, order), GetParam(), "no fault");
    const int allocations = gl::chances(Fault::allocation);
    EXPECT_GT(allocations, 10);
    for (int n = 1; n <= allocations; ++n) {
        gl::arm(Fault::allocation, n);
        expect_right(enlarge_on(GetParam(), picture, order), GetParam(),
                     "allocation " + std::to_string(n));
    }
}

TEST_P(Faults, WithoutAnyMemoryTheCpuDoesIt) {
    gl::arm(Fault::allocation, 5, 1000000);
    expect_right(enlarge_on(GetParam(), picture, order), Device::cpu, "no memory");
}

TEST_P(Faults, ALostContextLeavesTheRestToTheCpuAndTheDeviceIsGone) {
    gl::arm(Fault::lost, 0);
    expect_right(enlarge_on(GetParam(), picture, order), GetParam(), "no fault");
    const int checks = gl::chances(Fault::lost);
    ASSERT_GT(checks, 3);
    for (int n = 1; n <= checks; ++n) {
        gl::forget_devices();
        gl::arm(Fault::lost, n);
        expect_right(enlarge_on(GetParam(), picture, order), Device::cpu,
                     "lost at check " + std::to_string(n));
        const Result next = enlarge_on(GetParam(), picture, order);
        EXPECT_EQ(next.outcome, Outcome::device_unavailable);
        EXPECT_NE(next.error.find("lost"), std::string::npos) << next.error;
    }
}

TEST_P(Faults, ASourceThatFailsEndsTheWork) {
    class Broken final : public Source {
        bool read(const Rect& r, float*, float*) override { return r.x0 == 0; }
    } source;
    EXPECT_EQ(enlarged_from(source), Outcome::source_failed);
}

// Drivers take names that are given back on another thread for nothing: their memory stays.
std::atomic<int> g_deleted{0}, g_lost{0};
std::thread::id g_own_thread;
PFNGLDELETEBUFFERSPROC g_delete_buffers;

void APIENTRY delete_buffers(GLsizei n, const GLuint* names) {
    ++(std::this_thread::get_id() == g_own_thread ? g_deleted : g_lost);
    g_delete_buffers(n, names);
}

TEST_P(Faults, ASourceThatThrowsLeavesNoMemoryBehind) {
    class Thrown final : public Source {
        bool read(const Rect& r, float* values, float* guide) override {
            if (r.x0 > 0)
                throw std::runtime_error("thrown by a source");
            std::fill_n(values, r.area() * 4, 0.5f);
            std::fill_n(guide, r.area(), 0.5f);
            return true;
        }
    } source;
    gl::Gpu& gpu = fresh_device();
    gpu.checks.tested_too = false;
    gpu.thread
        .post([&] {
            g_own_thread = std::this_thread::get_id();
            g_delete_buffers = gpu.context->gl.DeleteBuffers;
            gpu.context->gl.DeleteBuffers = delete_buffers;
        })
        .get();
    g_deleted = g_lost = 0;
    EXPECT_EQ(enlarged_from(source), Outcome::bad_job);
    EXPECT_GT(g_deleted, 0);
    EXPECT_EQ(g_lost, 0);
}

TEST_P(Faults, AJobCanBeCancelled) {
    order.job.progress = [](float) { return false; };
    EXPECT_EQ(enlarge_on(GetParam(), picture, order).outcome, Outcome::cancelled);
}

INSTANTIATE_TEST_SUITE_P(Devices, Faults, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test
