// SPDX-License-Identifier: Apache-2.0
// The modules of the running process - the program and its shared libraries - as ELF describes
// them.
//
// See "ELF-64 Object File Format", the psABI supplements for x86-64 and AArch64, and for
// DT_GNU_HASH the GNU linker's own description.
#pragma once

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
#define DDT_HAS_MODULES 1

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include <elf.h>
#include <link.h>

namespace ddt::elf {

/// The start of the page that `address` lies in.
uintptr_t page_of(uintptr_t address);

/// A module, valid within dl_iterate_phdr's callback that it was made in.
class Module {
public:
    explicit Module(const dl_phdr_info& info) : m_info(info) {}

    /// The file's path; empty for the program itself.
    const char* path() const { return m_info.dlpi_name ? m_info.dlpi_name : ""; }
    bool contains(uintptr_t address) const;
    /// Protection of the page that `address` lies in; PROT_NONE if it is not of this module.
    int protection(uintptr_t address) const;

    /// Find the tables, which what follows needs; false if the module has none.
    bool read_dynamic();

    /// The name that a library goes by; null without one.
    const char* soname() const { return m_soname ? m_strings + m_soname : nullptr; }
    /// True if the module asks for the library that goes by this name.
    bool needs(const char* soname) const;
    /// True if the module exports a symbol of this name.
    bool defines(const char* name) const;

    /// Call f(slot address) for each slot that may hold a function's address.
    template <typename F>
    void for_each_slot(F f) const {
        for (const Relocations& table : {m_jump, m_data})
            for (size_t i = 0; i < table.bytes / sizeof(ElfW(Rela)); ++i)
                if (holds_function(table.begin[i]))
                    f(m_info.dlpi_addr + table.begin[i].r_offset);
    }

private:
    struct Relocations {
        const ElfW(Rela) * begin = nullptr;
        size_t bytes = 0;
    };

    static bool holds_function(const ElfW(Rela) & entry);

    /// glibc turns offsets in the dynamic section into addresses, except in read-only ones.
    template <typename T>
    const T* table(const ElfW(Dyn) & entry) const {
        uintptr_t address = entry.d_un.d_ptr;
        if (address < m_info.dlpi_addr)
            address += m_info.dlpi_addr;
        return reinterpret_cast<const T*>(address);
    }

    const dl_phdr_info& m_info;
    const ElfW(Dyn) * m_dynamic = nullptr;
    const ElfW(Sym) * m_symbols = nullptr;
    const char* m_strings = nullptr;
    const uint32_t* m_hash = nullptr; ///< DT_GNU_HASH's table
    size_t m_soname = 0;              ///< offset within m_strings; 0: none
    Relocations m_jump, m_data;
};

} // namespace ddt::elf

#endif
