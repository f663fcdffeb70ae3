// SPDX-License-Identifier: Apache-2.0
#include "plugin/register/version.h"

#include <cstring>

#include "plugin/register/module.h"

namespace ddt {

#ifdef DDT_HAS_MODULES

namespace {

/// Calls f(module) for each module.
template <typename F>
void for_each_module(F f) {
    dl_iterate_phdr(
        [](dl_phdr_info* info, size_t, void* data) {
            elf::Module module(*info);
            if (module.read_dynamic())
                (*static_cast<F*>(data))(module);
            return 0;
        },
        &f);
}

} // namespace

Versions versions_loaded(const char* stem, const void* function) {
    const size_t length = std::strlen(stem);
    const auto address = reinterpret_cast<uintptr_t>(function);
    const auto self = reinterpret_cast<uintptr_t>(&versions_loaded);
    const char *ours = nullptr, *theirs = nullptr;
    for_each_module([&](const elf::Module& module) {
        const char* name = module.soname();
        if (!name || std::strncmp(name, stem, length) != 0)
            return;
        (module.contains(address) ? ours : theirs) = name;
    });
    bool needed = false;
    if (ours)
        for_each_module([&](const elf::Module& module) {
            needed |= !module.contains(self) && module.needs(ours);
        });
    Versions versions;
    versions.ours = ours ? ours + length : "";
    versions.theirs = theirs ? theirs + length : "";
    // Two of the same version have one name, and this module got the program's.
    versions.mixed = ours && theirs && std::strcmp(ours, theirs) != 0 && !needed;
    return versions;
}

#else

Versions versions_loaded(const char*, const void*) {
    return {};
}

#endif

} // namespace ddt
