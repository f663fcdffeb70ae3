// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/hardware.h"

#include <cerrno>
#include <cstring>
#include <initializer_list>
#include <string_view>

#include <dirent.h>
#include <unistd.h>

namespace ddt::gl {

#ifdef __linux__

namespace {

/// Whether the folder has a file whose name begins with one of `starts` and which this process may
/// use: drivers complain on stderr of those that it may not. A folder that is there but cannot be
/// read may have.
bool has_file(const std::string& folder, std::initializer_list<const char*> starts) {
    DIR* entries = opendir(folder.c_str());
    if (!entries)
        return errno != ENOENT && errno != ENOTDIR;
    bool found = false;
    while (const dirent* entry = readdir(entries))
        for (const char* start : starts)
            found |= std::string_view(entry->d_name).substr(0, std::strlen(start)) == start &&
                     access((folder + '/' + entry->d_name).c_str(), R_OK | W_OK) == 0;
    closedir(entries);
    return found;
}

} // namespace

bool hardware_possible(const std::string& folder) {
    // The kernel's own drivers; NVIDIA's, of cards and of Tegra; Windows' below a guest of it.
    return has_file(folder + "/dri", {"renderD", "card"}) ||
           has_file(folder, {"nvidia", "nvhost", "nvmap"}) || hardware_unlisted(folder);
}

bool hardware_unlisted(const std::string& folder) {
    return has_file(folder, {"dxg"});
}

#else

bool hardware_possible(const std::string&) {
    return true;
}

bool hardware_unlisted(const std::string&) {
    return false;
}

#endif

} // namespace ddt::gl
