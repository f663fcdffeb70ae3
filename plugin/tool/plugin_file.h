// SPDX-License-Identifier: Apache-2.0
// The plugin, as the tool finds it.
#pragma once

#include <string>
#include <vector>

namespace ddt::tool {

/// Load the plugin into this process and say, a line each, where it is, what it redirected and what
/// it could not. It is looked for in the folders of OpenImageIO's environment variable, then where
/// it is built or installed, as seen from this program.
std::vector<std::string> describe_plugin();

} // namespace ddt::tool
