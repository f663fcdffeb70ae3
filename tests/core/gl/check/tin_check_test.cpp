// SPDX-License-Identifier: Apache-2.0
// The programs for meshes of points are checked before they are used; where one is wrong, or fails,
// the CPU does the work and a line says why.
#include <optional>
#include <set>
#include <sstream>

#include "core/gl/context/faults.h"
#include "core/gl/gpu.h"
#include "ddt/names.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/shaken_grid.h"
#include "tests/environment.h"

namespace ddt::test {
namespace {

struct TinChange {
    const char *constant, *value;
};

/// A constant of the program, and another value that is not right. (Of tin.glsl's marks the last
/// ones of their line.)
TinChange tin_change_of(const std::string& program) {
    const auto has = [&](const char* part) { return program.find(part) != program.npos; };
    if (has("tin_faces.comp"))
        return {"reciprocal_magic", "2120000000"};
    if (has("tin_evaluate.comp"))
        return has("abn") || has("scf") ? TinChange{"rsqrt_magic", "1597460000"}
                                        : TinChange{"reciprocal_magic", "2120000000"};
    if (has("tin_anneal_draw.comp"))
        return {"drawn[m]", "0u"};
    if (has("tin_anneal_select.comp"))
        return {"natural_log_2", "0.5"};
    if (has("tin_accept.comp"))
        return {"winner", "0, accepted = 4, rejected = 5"};
    return {"accepted", has("tin_flip.comp") ? "9, rejected = 5" : "0, rejected = 5"};
}

class TinCheck : public OnDevice {
protected:
    void SetUp() override {
        OnDevice::SetUp();
        m_verbose.emplace("DDT_VERBOSE", "1");
    }
    void TearDown() override {
        gl::change_constant("", "", "");
        gl::arm(gl::Fault::allocation, 0);
        gl::forget_devices();
    }

    /// Flip; true if on the device. `lines`: what was said of failures.
    bool on_device(const MeshOptions& options, std::vector<std::string>& lines) {
        std::vector<float> guide;
        PointMesh cpu = shaken_grid(9, 8, 5, guide), device = cpu;
        EXPECT_TRUE(optimise(cpu, guide.data(), options, nullptr, nullptr, {}, Device::cpu));
        MeshReport report;
        testing::internal::CaptureStderr();
        EXPECT_TRUE(optimise(device, guide.data(), options, &report, nullptr, {}, GetParam()));
        std::istringstream said(testing::internal::GetCapturedStderr());
        for (std::string line; std::getline(said, line);)
            if (line.find("finished on the CPU") != line.npos)
                lines.push_back(line);
        EXPECT_EQ(cpu.triangles, device.triangles);
        return report.statistics.device == GetParam();
    }

private:
    std::optional<Environment> m_verbose; ///< once the device is known
};

TEST_P(TinCheck, EveryProgramIsCheckedBeforeItIsUsedAndAWrongOneIsNot) {
    std::set<std::string> proved; // of those that do not look at the cost: by file
    for (const Scheme scheme : {Scheme::maxgain, Scheme::annealing})
        for (const std::string& cost : cost_names()) {
            MeshOptions options;
            find_cost(cost, options.cost);
            options.scheme = scheme;
            const bool annealed = scheme == Scheme::annealing;
            options.max_iterations = annealed ? 4 : 64;
            std::vector<std::string> lines;
            gl::Gpu& right = fresh_device();
            right.thread.post([&] { EXPECT_EQ(right.checks.differs(right, options), ""); }).get();
            const std::set<std::string> checked = programs_of(right);
            EXPECT_TRUE(on_device(options, lines));
            EXPECT_EQ(programs_of(right), checked) << "a program was used that the check did not";
            EXPECT_TRUE(lines.empty());
            EXPECT_EQ(checked.size(), annealed ? 7u : 5u);
            for (const std::string& program : checked) {
                const bool by_cost = program.find("tin_faces") == 0 ||
                                     program.find("tin_eval") == 0 ||
                                     program.find("tin_anneal_select") == 0;
                if (!proved.insert(by_cost ? program : program.substr(0, program.find(' '))).second)
                    continue;
                const TinChange change = tin_change_of(program);
                gl::change_constant(program, change.constant, change.value);
                fresh_device();
                EXPECT_FALSE(on_device(options, lines)) << program << " is wrong and used";
                ASSERT_EQ(lines.size(), 1u) << program;
                EXPECT_NE(lines[0].find(std::string("does not compute as the CPU does (") +
                                        (annealed ? "annealed " : "") + "points " + cost),
                          std::string::npos)
                    << lines[0];
                // What is known is not checked again, and heeded again.
                EXPECT_FALSE(on_device(options, lines)) << program;
                lines.clear();
                gl::change_constant("", "", "");
            }
        }
}

TEST_P(TinCheck, AFailureIsToldAndTheCpuDoesTheWork) {
    fresh_device().checks.tested_too = false;
    gl::arm(gl::Fault::allocation, 1);
    std::vector<std::string> lines;
    EXPECT_FALSE(on_device(MeshOptions(), lines));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].find("failed, finished on the CPU: "), std::string::npos) << lines[0];
    lines.clear();
    EXPECT_TRUE(on_device(MeshOptions(), lines));
}

// on_device() compares: what came back before must not be what the CPU goes on with.
TEST_P(TinCheck, WhereverMemoryIsMissingTheCpuDoesTheWork) {
    fresh_device().checks.tested_too = false;
    std::vector<std::string> lines;
    EXPECT_TRUE(on_device(MeshOptions(), lines)); // hardware is checked with it
    gl::arm(gl::Fault::allocation, 0);
    EXPECT_TRUE(on_device(MeshOptions(), lines));
    const int allocations = gl::chances(gl::Fault::allocation);
    EXPECT_GT(allocations, 20) << "buffers, and what travels to and from them";
    for (int n = 1; n <= allocations; ++n) {
        gl::arm(gl::Fault::allocation, n);
        EXPECT_FALSE(on_device(MeshOptions(), lines)) << n;
    }
    EXPECT_EQ(lines.size(), size_t(allocations));
}

// On one device: what is checked is the same code on all, and compiles for most of the time.
INSTANTIATE_TEST_SUITE_P(Devices, TinCheck, testing::Values(Device::egl), ddt::test::device_name);

} // namespace
} // namespace ddt::test
