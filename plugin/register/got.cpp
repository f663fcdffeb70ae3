// SPDX-License-Identifier: Apache-2.0
// See "ELF-64 Object File Format" and the psABI supplements for x86-64 and AArch64 for the tables
// read here. Relocations for function addresses have addend 0, so a slot holds the plain address.
#include "got.h"

#include <cstdint>
#include <cstring>
#include <initializer_list>

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

namespace ddt::got {
namespace {

#if defined(__x86_64__)
constexpr uint32_t type_jump_slot = R_X86_64_JUMP_SLOT;
constexpr uint32_t type_glob_dat = R_X86_64_GLOB_DAT;
constexpr uint32_t type_absolute = R_X86_64_64;
#else
constexpr uint32_t type_jump_slot = R_AARCH64_JUMP_SLOT;
constexpr uint32_t type_glob_dat = R_AARCH64_GLOB_DAT;
constexpr uint32_t type_absolute = R_AARCH64_ABS64;
#endif

uintptr_t page_down(uintptr_t address) {
    static const auto page = uintptr_t(sysconf(_SC_PAGESIZE));
    return address & ~(page - 1);
}

/// Store `value` in a page whose protection is `protection`, which it has again afterwards.
bool store(uintptr_t address, uintptr_t value, int protection) {
    auto* page = reinterpret_cast<void*>(page_down(address));
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

/// A loaded module, as the dynamic linker describes it.
class Module {
public:
    explicit Module(const dl_phdr_info& info) : m_info(info) {}

    bool contains(uintptr_t address) const { return protection(address) != PROT_NONE; }

    /// Protection of the page that `address` lies in; PROT_NONE if it is not of this module.
    int protection(uintptr_t address) const {
        int result = PROT_NONE;
        for (int i = 0; i < m_info.dlpi_phnum; ++i) {
            const ElfW(Phdr)& header = m_info.dlpi_phdr[i];
            const uintptr_t begin = m_info.dlpi_addr + header.p_vaddr;
            const uintptr_t end = begin + header.p_memsz;
            if (header.p_type == PT_LOAD && address >= begin && address < end)
                result |= ((header.p_flags & PF_R) ? PROT_READ : 0) |
                          ((header.p_flags & PF_W) ? PROT_WRITE : 0) |
                          ((header.p_flags & PF_X) ? PROT_EXEC : 0);
        }
        // Read-only after relocation; its last page only if the range covers it wholly.
        for (int i = 0; i < m_info.dlpi_phnum; ++i) {
            const ElfW(Phdr)& header = m_info.dlpi_phdr[i];
            const uintptr_t begin = m_info.dlpi_addr + header.p_vaddr;
            if (header.p_type == PT_GNU_RELRO && address >= page_down(begin) &&
                address < page_down(begin + header.p_memsz))
                result &= ~PROT_WRITE;
        }
        return result;
    }

    /// Find the tables; false if the module has none.
    bool read_dynamic() {
        const ElfW(Dyn)* dynamic = nullptr;
        for (int i = 0; i < m_info.dlpi_phnum; ++i)
            if (m_info.dlpi_phdr[i].p_type == PT_DYNAMIC)
                dynamic = reinterpret_cast<const ElfW(Dyn)*>(m_info.dlpi_addr +
                                                             m_info.dlpi_phdr[i].p_vaddr);
        if (!dynamic)
            return false;
        for (; dynamic->d_tag != DT_NULL; ++dynamic) {
            switch (dynamic->d_tag) {
            case DT_SYMTAB:
                m_symbols = table<ElfW(Sym)>(*dynamic);
                break;
            case DT_STRTAB:
                m_strings = table<char>(*dynamic);
                break;
            case DT_JMPREL:
                m_jump.begin = table<ElfW(Rela)>(*dynamic);
                break;
            case DT_PLTRELSZ:
                m_jump.bytes = dynamic->d_un.d_val;
                break;
            case DT_RELA:
                m_data.begin = table<ElfW(Rela)>(*dynamic);
                break;
            case DT_RELASZ:
                m_data.bytes = dynamic->d_un.d_val;
                break;
            default:
                break;
            }
        }
        return m_symbols && m_strings;
    }

    /// Call f(slot address, symbol name, type) for each slot that may hold a function's address.
    template <typename F>
    void for_each_slot(F f) const {
        for (const Relocations& table : {m_jump, m_data}) {
            if (!table.begin)
                continue;
            for (size_t i = 0; i < table.bytes / sizeof(ElfW(Rela)); ++i) {
                const ElfW(Rela)& entry = table.begin[i];
                const auto type = uint32_t(ELF64_R_TYPE(entry.r_info));
                if (type != type_jump_slot && type != type_glob_dat && type != type_absolute)
                    continue;
                const ElfW(Sym)& symbol = m_symbols[ELF64_R_SYM(entry.r_info)];
                f(m_info.dlpi_addr + entry.r_offset, m_strings + symbol.st_name, type);
            }
        }
    }

private:
    struct Relocations {
        const ElfW(Rela) * begin = nullptr;
        size_t bytes = 0;
    };

    /// glibc turns offsets in the dynamic section into addresses, except in read-only ones.
    template <typename T>
    const T* table(const ElfW(Dyn) & entry) const {
        uintptr_t address = entry.d_un.d_ptr;
        if (address < m_info.dlpi_addr)
            address += m_info.dlpi_addr;
        return reinterpret_cast<const T*>(address);
    }

    const dl_phdr_info& m_info;
    const ElfW(Sym) * m_symbols = nullptr;
    const char* m_strings = nullptr;
    Relocations m_jump, m_data;
};

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

void patch(const Module& module, const Target& target, uintptr_t slot, const char* name,
           uint32_t type, Report& report) {
    const uintptr_t value = __atomic_load_n(reinterpret_cast<uintptr_t*>(slot), __ATOMIC_ACQUIRE);
    // A function not called yet under lazy binding: the slot leads to the module's own stub.
    const bool unbound = type == type_jump_slot && value != target.from &&
                         std::strcmp(name, target.name) == 0 && module.contains(value);
    if ((value == target.from || unbound) && store(slot, target.to, module.protection(slot)))
        ++report.slots;
}

int visit(dl_phdr_info* info, size_t, void* data) {
    const Work& work = *static_cast<const Work*>(data);
    Module module(*info);
    if (module.contains(work.targets[0].to) || !module.read_dynamic())
        return 0;
    module.for_each_slot([&](uintptr_t slot, const char* name, uint32_t type) {
        for (size_t i = 0; i < work.count; ++i)
            patch(module, work.targets[i], slot, name, type, *work.report);
    });
    for (size_t i = 0; i < work.count; ++i) {
        const Target& target = work.targets[i];
        if (module.contains(target.symbol) &&
            store(target.symbol, target.to - target.base, module.protection(target.symbol)))
            ++work.report->exports;
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
        if (found < most && find_symbol(redirects[i], targets[found]))
            ++found;
        else
            report.missed = redirects[i].label;
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
    if (count)
        report.missed = redirects[0].label;
    return report;
}

} // namespace ddt::got

#endif
