// SPDX-License-Identifier: Apache-2.0
#include "ddt/devices.h"

#include <gtest/gtest.h>

#include "tests/environment.h"

namespace {

TEST(Devices, TheCpuIsCalledSo) {
    ddt::Job job;
    job.device = ddt::Device::cpu;
    std::string line = "left over";
    EXPECT_TRUE(ddt::describe_device(job, line));
    EXPECT_EQ(line, "cpu");
}

TEST(Devices, WhatIsNoneIsRefused) {
    ddt::Job job;
    job.device = ddt::Device(9);
    std::string line;
    EXPECT_FALSE(ddt::describe_device(job, line));
    EXPECT_EQ(line.find("ddt: option"), 0u) << line;
    EXPECT_NE(line.find("egl"), std::string::npos) << line; // what is allowed
}

TEST(Devices, WhatCannotBeHadIsNamed) {
    const ddt::Environment device("DDT_DEVICE", "no\nsuch");
    std::string line;
    EXPECT_FALSE(ddt::describe_device(ddt::Job(), line));
    EXPECT_EQ(line.find("ddt: "), 0u) << line;
    EXPECT_NE(line.find("no such"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
}

TEST(Devices, NamesAreCheckedWithoutOpeningAny) {
    std::string line = "left over";
    for (const char* name : {"", "auto", "cpu", "egl", "osmesa"}) {
        const ddt::Environment device("DDT_DEVICE", name);
        EXPECT_TRUE(ddt::check_device(ddt::Device::automatic, line)) << name << ": " << line;
        EXPECT_EQ(line, "left over") << name;
    }
    const ddt::Environment device("DDT_DEVICE", "voodoo");
    EXPECT_TRUE(ddt::check_device(ddt::Device::cpu, line)) << line;
    EXPECT_FALSE(ddt::check_device(ddt::Device::automatic, line));
    EXPECT_EQ(line.find("ddt: DDT_DEVICE=voodoo is not one of auto, cpu"), 0u) << line;
}

} // namespace
