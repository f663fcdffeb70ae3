// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/filter_keys.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "ddt/option_table.h"

namespace ddt::tool {
namespace {

std::vector<std::string> sorted(std::vector<std::string> keys) {
    std::sort(keys.begin(), keys.end());
    return keys;
}

/// Who adds an option says here, or in filter_keys.h, whether it counts for the command.
void expect_all(std::vector<std::string> counting,
                const std::vector<std::string>& without_meaning) {
    std::vector<std::string> all;
    for (const Option& option : option_table())
        all.emplace_back(option.key);
    counting.insert(counting.end(), without_meaning.begin(), without_meaning.end());
    EXPECT_EQ(sorted(counting), sorted(all));
}

TEST(FilterKeys, EachOptionCountsOrDoesNot) {
    expect_all(fill_keys(), {"blur", "contour", "meshes", "min_gain", "start", "clipped",
                             "consistency", "fitted", "limit", "soft"});
    expect_all(mesh_keys(), {"meshes", "clipped", "consistency", "fitted", "limit", "soft"});
    expect_all(scatter_keys(), {"light", "blur", "contour", "meshes", "start", "clipped",
                                "consistency", "fitted", "limit", "soft", "holes"});
}

} // namespace
} // namespace ddt::tool
