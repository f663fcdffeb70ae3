// SPDX-License-Identifier: Apache-2.0
#include "core/base/control_groups.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/temporary.h"

namespace ddt {
namespace {

constexpr int64_t any_memory = std::numeric_limits<int64_t>::max();
constexpr int any_processors = std::numeric_limits<int>::max();

/// A folder where control groups are mounted.
class Mounted {
public:
    explicit Mounted(const char* name) : m_root(temporary(name)) {}
    void put(const char* file, const char* text) const {
        std::filesystem::create_directories((m_root / file).parent_path());
        std::ofstream(m_root / file) << text;
    }
    int64_t memory(const char* groups) const {
        std::istringstream text(groups);
        return memory_of_groups(text, m_root.string());
    }
    int processors(const char* groups) const {
        std::istringstream text(groups);
        return processors_of_groups(text, m_root.string());
    }

private:
    const std::filesystem::path m_root;
};

TEST(ControlGroups, MemoryIsTheLeastOfAGroupAndThoseAboutIt) {
    const Mounted mounted("memory");
    mounted.put("memory.max", "max\n");
    mounted.put("job/memory.max", "5000\n");
    mounted.put("job/step/memory.max", "7000\n");
    mounted.put("memory/slurm/memory.limit_in_bytes", "3000\n");
    EXPECT_EQ(mounted.memory("0::/job/step\n"), 5000);
    EXPECT_EQ(mounted.memory("0::/job\n"), 5000);
    EXPECT_EQ(mounted.memory("0::/other\n"), any_memory);
    EXPECT_EQ(mounted.memory("12:cpu:/slurm\n4:memory:/slurm/step\n0::/other\n"), 3000);
    EXPECT_EQ(mounted.memory(""), any_memory);
    EXPECT_EQ(mounted.memory("4:memory\nmemory:/slurm\n"), any_memory);
    mounted.put("memory.max", "2000\n"); // a container's own
    EXPECT_EQ(mounted.memory("0::/\n"), 2000);
    EXPECT_EQ(mounted.memory("0::/job\n"), 2000);
}

TEST(ControlGroups, AQuotaIsWorthProcessors) {
    const Mounted mounted("quota");
    mounted.put("pod/cpu.max", "400000 100000\n");
    mounted.put("pod/box/cpu.max", "max 100000\n");
    mounted.put("pod/small/cpu.max", "20000 100000\n");
    mounted.put("pod/half/cpu.max", "250001 100000\n");
    mounted.put("pod/cut/cpu.max", "300000");
    EXPECT_EQ(mounted.processors("0::/pod\n"), 4);
    EXPECT_EQ(mounted.processors("0::/pod/box\n"), 4);
    EXPECT_EQ(mounted.processors("0::/pod/small\n"), 1);
    EXPECT_EQ(mounted.processors("0::/pod/half\n"), 3);
    EXPECT_EQ(mounted.processors("0::/pod/cut\n"), 4);
    EXPECT_EQ(mounted.processors("0::/\n"), any_processors);
    EXPECT_EQ(mounted.processors(""), any_processors);
}

/// As French has it, with whatever space is between the digits of thousands.
struct Thousands : std::numpunct<char> {
    char do_thousands_sep() const override { return ' '; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(ControlGroups, TheHostsLocaleDoesNotMatter) {
    const Mounted mounted("french");
    mounted.put("pod/cpu.max", "400000 100000\n");
    mounted.put("pod/memory.max", "5000 \n");
    const std::locale before =
        std::locale::global(std::locale(std::locale::classic(), new Thousands));
    EXPECT_EQ(mounted.processors("0::/pod\n"), 4);
    EXPECT_EQ(mounted.memory("0::/pod\n"), 5000);
    std::locale::global(before);
}

TEST(ControlGroups, AQuotaOfTheFirstVersionIsInTwoFiles) {
    const Mounted mounted("quota1");
    mounted.put("cpu/cpu.cfs_quota_us", "-1\n");
    mounted.put("cpu/cpu.cfs_period_us", "100000\n");
    mounted.put("cpu/docker/cpu.cfs_quota_us", "150000\n");
    mounted.put("cpu/docker/cpu.cfs_period_us", "50000\n");
    mounted.put("cpu/cut/cpu.cfs_quota_us", "150000\n");
    EXPECT_EQ(mounted.processors("3:cpu,cpuacct:/docker\n0::/docker\n"), 3);
    EXPECT_EQ(mounted.processors("3:cpuacct,cpu:/docker/inner\n"), 3);
    EXPECT_EQ(mounted.processors("3:cpu:/\n"), any_processors);
    EXPECT_EQ(mounted.processors("3:cpu:/cut\n"), any_processors);
    EXPECT_EQ(mounted.processors("3:cpuset:/docker\n5:memory:/docker\n"), any_processors);
}

TEST(ControlGroups, ThisProcessMayWork) {
    EXPECT_GE(processors_of_groups(), 1);
    EXPECT_GE(memory_of_groups(), 1 << 20);
}

} // namespace
} // namespace ddt
