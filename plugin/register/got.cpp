// SPDX-License-Identifier: Apache-2.0
// Relocations for function addresses have addend 0, so a slot holds the plain address.
#include "plugin/register/got.h"

#include "plugin/register/module.h"

#ifdef DDT_HAS_MODULES

#include <dlfcn.h>
#include <sys/mman.h>

namespace ddt::got {
namespace {

using elf::Module;

/// Store `value` in a page whose protection is `protection`, which it has again afterwards.
bool store(uintptr_t address, uintptr_t value, int protection) {
    auto* page = reinterpret_cast<void*>(elf::page_of(address));
    const bool locked = !(protection & PROT_WRITE);
    // An aligned word lies in one page.
    if (locked && mprotect(page, sizeof(uintptr_t), protection | PROT_WRITE) != 0)
        return false;
    // Other threads may be calling through this very slot.
    __atomic_store_n(reinterpret_cast<uintptr_t*>(address), value, __ATOMIC_RELEASE);
    if (locked)
        mprotect(page, sizeof(uintptr_t), protection);
    return true;
}

/// A redirect with the symbol that it concerns.
struct Target {
    uintptr_t from = 0, to = 0;
    const char* name = nullptr;
    uintptr_t symbol = 0; ///< address of the value field of its entry in the symbol table
    uintptr_t base = 0;   ///< what that value is relative to
};

bool find_symbol(const Redirect& redirect, Target& target) {
    Dl_info info;
    ElfW(Sym)* symbol = nullptr;
    if (!dladdr1(redirect.from, &info, reinterpret_cast<void**>(&symbol), RTLD_DL_SYMENT) ||
        !symbol || info.dli_saddr != redirect.from)
        return false;
    target.from = reinterpret_cast<uintptr_t>(redirect.from);
    target.to = reinterpret_cast<uintptr_t>(redirect.to);
    target.name = info.dli_sname;
    target.symbol = reinterpret_cast<uintptr_t>(&symbol->st_value);
    target.base = target.from - symbol->st_value;
    return true;
}

struct Work {
    const Target* targets;
    size_t count;
    Report* report;
};

/// The calls and pointers of one module that lead to a target. A call that lazy binding has not
/// bound yet is none of them: it will be bound by the symbol table of the library it belongs to,
/// which is not always the one redirected, when there are several of the same names.
void patch_slots(const Module& module, const Work& work) {
    module.for_each_slot([&](uintptr_t slot) {
        const uintptr_t value =
            __atomic_load_n(reinterpret_cast<uintptr_t*>(slot), __ATOMIC_ACQUIRE);
        for (size_t i = 0; i < work.count; ++i) {
            const Target& target = work.targets[i];
            if (value != target.from)
                continue;
            if (!store(slot, target.to, module.protection(slot))) {
                ++work.report->refused;
                continue;
            }
            ++work.report->slots;
            if (module.contains(target.symbol))
                ++work.report->own_slots;
        }
    });
}

/// The symbol table of a library that defines a target.
void patch_symbols(const Module& module, const Work& work) {
    for (size_t i = 0; i < work.count; ++i) {
        const Target& target = work.targets[i];
        if (!module.contains(target.symbol))
            continue;
        if (store(target.symbol, target.to - target.base, module.protection(target.symbol)))
            ++work.report->exports;
        else
            ++work.report->refused;
    }
}

/// Whether a library is another one with the targets' names.
bool is_other(const Module& module, const Work& work) {
    for (size_t i = 0; i < work.count; ++i)
        if (!module.contains(work.targets[i].symbol) && module.defines(work.targets[i].name))
            return true;
    return false;
}

int visit(dl_phdr_info* info, size_t, void* data) {
    const Work& work = *static_cast<const Work*>(data);
    Module module(*info);
    if (module.contains(work.targets[0].to) || !module.read_dynamic())
        return 0;
    patch_symbols(module, work);
    patch_slots(module, work);
    if (is_other(module, work)) {
        ++work.report->others;
        work.report->other = module.path();
    }
    return 0;
}

} // namespace

Report redirect(const Redirect* redirects, size_t count) noexcept {
    Report report;
    constexpr size_t most = 64;
    Target targets[most];
    size_t found = 0;
    for (size_t i = 0; i < count; ++i) {
        if (found < most && find_symbol(redirects[i], targets[found])) {
            ++found;
        } else {
            ++report.missed;
            report.last_missed = redirects[i].label;
        }
    }
    if (found) {
        Work work{targets, found, &report};
        dl_iterate_phdr(visit, &work);
    }
    return report;
}

} // namespace ddt::got

#else

namespace ddt::got {

Report redirect(const Redirect* redirects, size_t count) noexcept {
    Report report;
    report.missed = int(count);
    if (count)
        report.last_missed = redirects[0].label;
    return report;
}

} // namespace ddt::got

#endif
