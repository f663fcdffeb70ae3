// SPDX-License-Identifier: Apache-2.0
// What happens when the plugin is loaded.
//
// OIIO loads plugins under a mutex that is not recursive: nothing here may call a function of OIIO.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>

#include <OpenImageIO/imageio.h>

#include "core/base/guarded.h"
#include "core/base/log.h"
#include "plugin/register/hooks.h"
#include "plugin/register/version.h"

// The reader's, that OpenImageIO looks at before it takes the plugin.
extern "C" int ddt_imageio_version;

namespace {

void on_load() noexcept;

/// If LD_PRELOAD brought the plugin here, take it off that list: programs that this one starts need
/// no image library, and a shell that carries libOpenImageIO hangs in its subshells (log4cplus, one
/// of its dependencies, waits at exit for a thread that a forked process does not have).
void leave_preload_list() {
    const char* list = std::getenv("LD_PRELOAD");
    Dl_info self;
    if (!list || !dladdr(reinterpret_cast<void*>(&on_load), &self))
        return;
    std::string rest;
    bool listed = false;
    for (const char* p = list; *p;) {
        const size_t length = std::strcspn(p, ": ");
        const std::string entry(p, length);
        if (entry == self.dli_fname)
            listed = true;
        else if (!entry.empty())
            rest += (rest.empty() ? "" : ":") + entry;
        p += length + (p[length] != 0);
    }
    if (!listed)
        return;
    if (rest.empty())
        unsetenv("LD_PRELOAD");
    else
        setenv("LD_PRELOAD", rest.c_str(), 1);
}

/// Print lines, each after "ddt: ", to standard error.
void print(const std::string& lines) {
    for (size_t begin = 0; begin < lines.size();) {
        const size_t end = std::min(lines.find('\n', begin), lines.size());
        std::fprintf(stderr, "ddt: %s\n", lines.substr(begin, end - begin).c_str());
        begin = end + 1;
    }
}

/// Nothing fits a program that uses another OpenImageIO, though plugins of 2.4 and 2.5 have the
/// same number for OpenImageIO itself. It is told always: the filters are not there.
bool fits_the_program() {
    const ddt::Versions versions = ddt::versions_loaded(
        "libOpenImageIO.so.", reinterpret_cast<void*>(&OIIO::openimageio_version));
    if (!versions.mixed)
        return true;
    print("this plugin is built for OpenImageIO " + versions.ours + ", the program uses " +
          versions.theirs + ": it has none of the filters");
    ddt_imageio_version = -1; // OpenImageIO does not take such a plugin
    return false;
}

__attribute__((constructor)) void on_load() noexcept {
    const bool talk = ddt::verbose();
    const ddt::Caught caught = ddt::guarded_call(nullptr, [&] {
        leave_preload_list();
        if (!fits_the_program())
            return;
        ddt::redirect_all();
        if (talk)
            print(ddt::describe_redirects());
    });
    if (talk && caught != ddt::Caught::nothing)
        std::fputs("ddt: could not register\n", stderr);
}

} // namespace

// For `ddt info`: what describe_redirects() says.
extern "C" __attribute__((visibility("default"))) const char* ddt_redirects() noexcept {
    const char* words = "";
    ddt::guarded_call(nullptr, [&] {
        static const auto* text = new std::string(ddt::describe_redirects());
        words = text->c_str();
    });
    return words;
}
