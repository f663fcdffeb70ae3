// SPDX-License-Identifier: Apache-2.0
// The GL thread among other threads, other contexts, children, and at the end of a process.
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "core/gl/context/context.h"
#include "core/gl/context/faults.h"
#include "tests/child_process.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"
#include "tests/core/plain.h"
#include "tests/core/random.h"
#include "tests/environment.h"
#include "tests/temporary.h"

namespace ddt::test {
namespace {

class Process : public OnDevice {
protected:
    Picture picture = make_picture(Content::photo, 90, 70, 4, 2);
    Order order = make_order();
    static Order make_order() {
        Order o;
        o.out_width = 200;
        o.out_height = 160;
        return o;
    }
};

TEST_P(Process, ManyThreadsAtOnce) {
    const Result cpu = enlarge_on(Device::cpu, picture, order);
    std::vector<Result> results(6);
    std::vector<std::thread> threads;
    for (Result& r : results)
        threads.emplace_back([&] { r = enlarge_on(GetParam(), picture, order); });
    for (auto& t : threads)
        t.join();
    for (const Result& r : results) {
        EXPECT_EQ(r.outcome, Outcome::done) << r.error;
        EXPECT_EQ(r.bits, cpu.bits);
        EXPECT_EQ(r.statistics.device, GetParam());
    }
}

TEST_P(Process, AHostWithAContextOfItsOwnKeepsIt) {
    std::string why;
    const auto host = GetParam() == Device::egl ? gl::make_egl_context(gl::Wanted::any, why)
                                                : gl::make_osmesa_context(why);
    ASSERT_TRUE(host) << why;
    GLuint buffer = 0;
    host->gl.GenBuffers(1, &buffer);
    host->gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    const float data[] = {1, 2, 3};
    host->gl.BufferData(GL_SHADER_STORAGE_BUFFER, sizeof data, data, GL_STATIC_DRAW);
    expect_same(GetParam(), picture, order, "beside a host's context");
    GLint bound = 0;
    host->gl.GetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &bound);
    EXPECT_EQ(GLuint(bound), buffer);
    float back[3] = {};
    host->gl.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof back, back);
    EXPECT_EQ(back[2], 3.0f);
    EXPECT_EQ(host->gl.GetError(), GLenum(GL_NO_ERROR));
}

TEST_P(Process, AForkedChildUsesTheCpu) {
    // oneTBB's threads do not survive a fork either, so the child works alone.
    order.job.threads = 1;
    const Result cpu = enlarge_on(Device::cpu, picture, order);
    ASSERT_EQ(enlarge_on(GetParam(), picture, order).statistics.device, GetParam());
    const Ended ended = in_child([&] {
        const Result r = enlarge_on(GetParam(), picture, order);
        const bool same = r.outcome == Outcome::done && r.bits == cpu.bits;
        return same && r.statistics.device == Device::cpu ? 7 : 1;
    });
    EXPECT_EQ(ended.code, 7);
    EXPECT_EQ(enlarge_on(GetParam(), picture, order).statistics.device, GetParam());
}

TEST_P(Process, AutomaticNeverPicksASoftwareRenderer) {
    // Large enough for a GPU to be looked for. Forked children use the CPU anyway, so not there.
    const Picture large = make_picture(Content::flat, 1000, 900, 1, 1);
    Order o;
    o.out_width = 1000;
    o.out_height = 900;
    o.job.threads = 1;
    o.job.mesh.max_iterations = 0;
    o.job.surface = plain_surface(Surface::linear);
    // Both with what devices the machine has and as if it had a card.
    std::filesystem::create_directories(temporary("dev/dri"));
    std::ofstream(temporary("dev/dri/card0")).put('x');
    for (const std::string& folder : {std::string("/dev"), temporary("dev")}) {
        gl::forget_devices();
        gl::look_for_hardware_in(folder);
        const Result result = enlarge_on(Device::automatic, large, o);
        EXPECT_EQ(result.outcome, Outcome::done);
        if (result.statistics.device == Device::cpu)
            continue;
        std::string why;
        bool forked = false;
        const gl::Gpu* gpu = gl::open(Device::automatic, why, forked);
        ASSERT_NE(gpu, nullptr) << why;
        EXPECT_FALSE(gpu->context->software) << gpu->context->renderer;
    }
    gl::look_for_hardware_in("/dev");
    gl::forget_devices();
}

TEST_P(Process, TheEnvironmentNamesTheDeviceOfAutomaticJobs) {
    {
        const Environment known("DDT_DEVICE", GetParam() == Device::egl ? "egl" : "osmesa");
        EXPECT_EQ(enlarge_on(Device::automatic, picture, order).statistics.device, GetParam());
        EXPECT_EQ(enlarge_on(Device::cpu, picture, order).statistics.device, Device::cpu);
    }
    const Environment unknown("DDT_DEVICE", "voodoo");
    const Result result = enlarge_on(Device::automatic, picture, order);
    EXPECT_EQ(result.outcome, Outcome::device_unavailable);
    EXPECT_NE(result.error.find("voodoo"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("osmesa"), std::string::npos) << result.error;
}

// A software renderer's threads are the host's if it has a context first, and keep denormals as it
// does: see GradientMean in shaders/surface.glsl. (Alone in its process, as ctest runs it; else
// another test may have had one.)
TEST(Egl, AHostThatKeepsDenormalsChangesNoBit) {
    const Environment software("LIBGL_ALWAYS_SOFTWARE", "1");
    std::string why;
    const auto host = gl::make_egl_context(gl::Wanted::any, why);
    if (!host)
        GTEST_SKIP() << why << " (./check installs what it needs)";
    Picture steep{24, 24, 1, {}, {}};
    Random random(3);
    for (int y = 0; y < steep.height; ++y)
        for (int x = 0; x < steep.width; ++x) {
            steep.values.push_back(y % 2 != 0 ? 0x1p46f : 0x1p-79f * (1 + random.unit()));
            steep.guide.push_back(float(y % 2));
        }
    Order order;
    order.out_width = order.out_height = 72;
    expect_same(Device::egl, steep, order, "steep rows");
}

/// As far as one GPU tells, or none.
TEST(Egl, TheEnvironmentNamesOneOfSeveralGpus) {
    std::string why;
    if (!gl::make_egl_context(gl::Wanted::any, why))
        GTEST_SKIP() << why;
    for (const char* name : {"31", "-1", "first", "0 "}) {
        const Environment none("DDT_EGL_DEVICE", name);
        EXPECT_EQ(gl::make_egl_context(gl::Wanted::any, why), nullptr) << name;
        EXPECT_NE(why.find("DDT_EGL_DEVICE=" + std::string(name) + " is none of"),
                  std::string::npos)
            << why;
    }
    const Environment unset("DDT_EGL_DEVICE", std::nullopt);
    const auto usual = gl::make_egl_context(gl::Wanted::hardware, why);
    const Environment set("DDT_EGL_DEVICE", "0");
    const auto first = gl::make_egl_context(gl::Wanted::any, why);
    EXPECT_EQ(first != nullptr, usual != nullptr) << why;
}

INSTANTIATE_TEST_SUITE_P(Devices, Process, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test
