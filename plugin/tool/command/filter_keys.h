// SPDX-License-Identifier: Apache-2.0
// Which options of --filter mean something to the commands to which not all do: what their --help
// lists (filter_flag()). A test says which list lacks an option that is new.
#pragma once

#include <string>
#include <vector>

namespace ddt::tool {

inline std::vector<std::string> fill_keys() {
    return {"light", "cost", "iterations", "scheme", "seed", "holes", "device"};
}

inline std::vector<std::string> mesh_keys() {
    return {"light",  "cost", "blur",  "contour", "min_gain", "iterations",
            "scheme", "seed", "start", "holes",   "device"};
}

inline std::vector<std::string> scatter_keys() {
    return {"cost", "min_gain", "iterations", "scheme", "seed", "device"};
}

} // namespace ddt::tool
