// SPDX-License-Identifier: Apache-2.0
// The plugin, as the tool finds it.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/oiioversion.h>

namespace ddt::tool {

/// OpenImageIO's environment variable of the folders of plugins.
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
inline constexpr const char* plugin_path_variable = "OPENIMAGEIO_PLUGIN_PATH";
#else
inline constexpr const char* plugin_path_variable = "OIIO_LIBRARY_PATH";
#endif

/// Load the plugin into this process and say, a line each, where it is, what it redirected and what
/// it could not. It is looked for in the folders of OpenImageIO's environment variable, then where
/// it is built or installed, as seen from this program.
std::vector<std::string> describe_plugin();

} // namespace ddt::tool
