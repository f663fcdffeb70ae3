// SPDX-License-Identifier: Apache-2.0
// Looking for hardware before anything is loaded.
#include "core/gl/context/hardware.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include "core/gl/context/faults.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"
#include "tests/core/plain.h"
#include "tests/environment.h"
#include "tests/temporary.h"

namespace ddt::test {
namespace {

TEST(Renderers, OfSoftwareAreKnownByTheirNames) {
    for (const char* name :
         {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "D3D12 (Microsoft Basic Render Driver)",
          "virgl (LLVMPIPE (LLVM 15.0.6, 256 bits))"})
        EXPECT_TRUE(gl::is_software(name)) << name;
    for (const char* name : {"NVIDIA H100 80GB HBM3/PCIe/SSE2", "D3D12 (NVIDIA GeForce RTX 3080)"})
        EXPECT_FALSE(gl::is_software(name)) << name;
}

TEST(Renderers, OfGuestsAreKnownByTheirNames) {
    for (const char* name : {"virgl (LLVMPIPE (LLVM 15.0.6, 256 bits))", "virgl (Intel UHD 620)",
                             "SVGA3D; build: RELEASE;  LLVM;"})
        EXPECT_TRUE(gl::is_guest(name)) << name;
    for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "NVIDIA H100 80GB HBM3/PCIe/SSE2"})
        EXPECT_FALSE(gl::is_guest(name)) << name;
    EXPECT_TRUE(gl::is_zink("virgl (zink Vulkan 1.3(Intel(R) UHD 620))"));
}

TEST(Renderers, ByWayOfAnotherApiAreNotTakenForTheOnesThatAreTested) {
    const char* const itself = "llvmpipe (LLVM 15.0.6, 256 bits)";
    EXPECT_TRUE(gl::is_tested(itself));
    EXPECT_FALSE(gl::is_zink(itself));
    const char* const layered = "zink (llvmpipe (LLVM 15.0.6, 256 bits))";
    EXPECT_TRUE(gl::is_software(layered));
    EXPECT_TRUE(gl::is_zink(layered));
    EXPECT_FALSE(gl::is_tested(layered));
    EXPECT_FALSE(gl::is_tested("softpipe")) << "has no OpenGL 4.3 so far";
    EXPECT_FALSE(gl::is_tested("NVIDIA H100 80GB HBM3/PCIe/SSE2"));
}

#ifdef __linux__

class Hardware : public testing::Test {
protected:
    void SetUp() override { gl::forget_devices(); }
    void TearDown() override {
        gl::arm(gl::Fault::library, 0);
        gl::look_for_hardware_in("/dev");
        gl::forget_devices();
    }

    /// A folder as /dev with these files.
    static std::string folder_with(const std::string& name, const std::vector<std::string>& files) {
        const std::filesystem::path folder = temporary(name);
        std::filesystem::create_directories(folder);
        for (const std::string& file : files) {
            std::filesystem::create_directories((folder / file).parent_path());
            std::ofstream(folder / file).put('x');
        }
        return folder;
    }

    /// Times that a job, large enough for a GPU to be looked for unless another height is given,
    /// tries to load a GL library.
    static int loads(Device device, int height = 900) {
        const Picture large = make_picture(Content::flat, 1000, height, 1, 1);
        Order order;
        order.out_width = 1000;
        order.out_height = height;
        order.job.threads = 1;
        order.job.mesh.max_iterations = 0;
        order.job.surface = plain_surface(Surface::linear);
        gl::arm(gl::Fault::library, 1, 1000);
        enlarge_on(device, large, order);
        return gl::chances(gl::Fault::library);
    }
};

TEST_F(Hardware, ShowsInItsDriversDeviceFiles) {
    EXPECT_FALSE(gl::hardware_possible(temporary("no such folder")));
    EXPECT_FALSE(gl::hardware_possible(folder_with("none", {"null", "tty", "dri/by-path/x"})));
    int i = 0;
    for (const char* file : {"dri/renderD128", "dri/card0", "nvidiactl", "nvidia0", "dxg"})
        EXPECT_TRUE(gl::hardware_possible(folder_with(std::to_string(++i), {"null", file})))
            << file;
    // What this process may not use it is not bothered with; root may use all.
    const std::string locked = folder_with("locked", {"dri/renderD128"});
    std::filesystem::permissions(locked + "/dri/renderD128", std::filesystem::perms::none);
    EXPECT_EQ(gl::hardware_possible(locked), geteuid() == 0);
}

TEST_F(Hardware, OfWindowsIsNotListed) {
    EXPECT_TRUE(gl::hardware_unlisted(folder_with("windows", {"dxg", "null"})));
    EXPECT_FALSE(gl::hardware_unlisted(folder_with("linux", {"nvidia0", "dri/card0"})));
}

TEST_F(Hardware, WithoutItNothingIsLoadedUnlessNamed) {
    gl::look_for_hardware_in(folder_with("bare", {"null"}));
    EXPECT_EQ(loads(Device::automatic), 0);
    EXPECT_EQ(loads(Device::egl), 1);
}

TEST_F(Hardware, WhereItMayBeItIsLookedFor) {
    gl::look_for_hardware_in(folder_with("card", {"dri/card0"}));
    EXPECT_EQ(loads(Device::automatic), 1);
    EXPECT_EQ(loads(Device::automatic), 0) << "looked for twice";
}

// `auto` leaves the work to the CPU without an error; who wonders why is told, once.
TEST_F(Hardware, ThatIsMissingIsToldOfOnceWhereLinesAreWanted) {
    const std::string folder = folder_with("silent", {"null"});
    const auto lines = [&](const char* wanted) {
        const Environment verbose("DDT_VERBOSE", wanted);
        testing::internal::CaptureStderr();
        loads(Device::automatic);
        std::istringstream said(testing::internal::GetCapturedStderr());
        std::vector<std::string> why;
        for (std::string line; std::getline(said, line);)
            if (line.find("no GPU is used") != line.npos)
                why.push_back(line);
        return why;
    };
    gl::look_for_hardware_in(folder);
    EXPECT_EQ(lines("0"), std::vector<std::string>());
    const std::vector<std::string> first = lines("1");
    ASSERT_EQ(first.size(), 1u);
    EXPECT_NE(first[0].find("no GPU's driver has files in " + folder), std::string::npos)
        << first[0];
    EXPECT_EQ(lines("1"), std::vector<std::string>());
}

TEST_F(Hardware, IsLookedForAfterManySmallJobs) {
    gl::look_for_hardware_in(folder_with("small", {"dri/card0"}));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(loads(Device::automatic, 250), 0) << i;
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(loads(Device::automatic, 19), 0) << "a GPU gains nothing on these";
    EXPECT_EQ(loads(Device::automatic, 250), 1);
}

#endif

} // namespace
} // namespace ddt::test
