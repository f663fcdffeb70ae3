// SPDX-License-Identifier: Apache-2.0
// What happens when the plugin is loaded.
//
// OIIO loads plugins under a mutex that is not recursive: nothing here may call a function of OIIO.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>

#include "core/base/verbose.h"
#include "hooks.h"

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

__attribute__((constructor)) void on_load() noexcept {
    const bool talk = ddt::verbose();
    try {
        leave_preload_list();
        ddt::Redirects list;
        ddt::add_filter_list(list);
        ddt::add_algorithms(list);
        const ddt::got::Report report = ddt::got::redirect(list.data(), list.size());
        if (talk && report.missed)
            std::fprintf(stderr, "ddt: could not redirect %s\n", report.missed);
        if (talk)
            std::fprintf(stderr, "ddt: redirected %zu functions in %d places, %d symbols\n",
                         list.size(), report.slots, report.exports);
    } catch (...) {
        if (talk)
            std::fputs("ddt: could not register\n", stderr);
    }
}

} // namespace
