// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/plugin_file.h"

#include <cstdlib>

#include <dlfcn.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>
#include <OpenImageIO/sysutil.h>

namespace ddt::tool {
namespace {

/// The first file of the plugin's name; empty if there is none.
std::string find_plugin() {
    std::vector<std::string> folders;
    if (const char* path = std::getenv(plugin_path_variable))
        OIIO::Strutil::split(path, folders, ":");
    const std::string self = OIIO::Filesystem::parent_path(OIIO::Sysutil::this_program_path());
    folders.push_back(self + "/../plugins");
    folders.push_back(self + "/" DDT_PLUGIN_FROM_BIN);
    for (const std::string& folder : folders)
        if (const std::string file = folder + "/ddt.imageio.so"; OIIO::Filesystem::exists(file))
            return file;
    return "";
}

} // namespace

std::vector<std::string> describe_plugin() {
    const std::string file = find_plugin();
    if (file.empty())
        return {std::string("not found; is it in a folder of $") + plugin_path_variable + "?"};
    std::vector<std::string> lines;
    void* plugin = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    auto* redirects =
        plugin ? reinterpret_cast<const char* (*)()>(dlsym(plugin, "ddt_redirects")) : nullptr;
    if (redirects)
        OIIO::Strutil::split(OIIO::Strutil::strip(redirects()), lines, "\n");
    else
        lines.push_back(std::string("cannot be loaded: ") + dlerror());
    lines.insert(lines.begin(), file);
    return lines;
}

} // namespace ddt::tool
