// SPDX-License-Identifier: Apache-2.0
#include "plugin/register/module.h"

#ifdef DDT_HAS_MODULES

#include <cstring>

#include <sys/mman.h>
#include <unistd.h>

namespace ddt::elf {
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

} // namespace

uintptr_t page_of(uintptr_t address) {
    static const auto page = uintptr_t(sysconf(_SC_PAGESIZE));
    return address & ~(page - 1);
}

bool Module::contains(uintptr_t address) const {
    return protection(address) != PROT_NONE;
}

int Module::protection(uintptr_t address) const {
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
        if (header.p_type == PT_GNU_RELRO && address >= page_of(begin) &&
            address < page_of(begin + header.p_memsz))
            result &= ~PROT_WRITE;
    }
    return result;
}

bool Module::read_dynamic() {
    for (int i = 0; i < m_info.dlpi_phnum; ++i)
        if (m_info.dlpi_phdr[i].p_type == PT_DYNAMIC)
            m_dynamic =
                reinterpret_cast<const ElfW(Dyn)*>(m_info.dlpi_addr + m_info.dlpi_phdr[i].p_vaddr);
    if (!m_dynamic)
        return false;
    for (const ElfW(Dyn)* entry = m_dynamic; entry->d_tag != DT_NULL; ++entry) {
        switch (entry->d_tag) {
        case DT_SYMTAB:
            m_symbols = table<ElfW(Sym)>(*entry);
            break;
        case DT_STRTAB:
            m_strings = table<char>(*entry);
            break;
        case DT_GNU_HASH:
            m_hash = table<uint32_t>(*entry);
            break;
        case DT_SONAME:
            m_soname = entry->d_un.d_val;
            break;
        case DT_JMPREL:
            m_jump.begin = table<ElfW(Rela)>(*entry);
            break;
        case DT_PLTRELSZ:
            m_jump.bytes = entry->d_un.d_val;
            break;
        case DT_RELA:
            m_data.begin = table<ElfW(Rela)>(*entry);
            break;
        case DT_RELASZ:
            m_data.bytes = entry->d_un.d_val;
            break;
        default:
            break;
        }
    }
    for (Relocations* relocations : {&m_jump, &m_data})
        if (!relocations->begin)
            relocations->bytes = 0;
    return m_symbols && m_strings;
}

bool Module::needs(const char* soname) const {
    for (const ElfW(Dyn)* entry = m_dynamic; entry->d_tag != DT_NULL; ++entry)
        if (entry->d_tag == DT_NEEDED && std::strcmp(m_strings + entry->d_un.d_val, soname) == 0)
            return true;
    return false;
}

bool Module::defines(const char* name) const {
    if (!m_hash)
        return false; // linkers have written this table by default for long
    const uint32_t buckets = m_hash[0], first = m_hash[1], filters = m_hash[2];
    const uint32_t* bucket = m_hash + 4 + size_t(filters) * (sizeof(ElfW(Addr)) / sizeof(uint32_t));
    const uint32_t* chain = bucket + buckets;
    uint32_t hash = 5381;
    for (const char* c = name; *c; ++c)
        hash = hash * 33 + static_cast<unsigned char>(*c);
    uint32_t i = buckets ? bucket[hash % buckets] : 0;
    if (i < first)
        return false;
    for (;; ++i) {
        const uint32_t entry = chain[i - first]; // its last bit ends the chain
        if ((entry | 1) == (hash | 1) && m_symbols[i].st_shndx != SHN_UNDEF &&
            std::strcmp(m_strings + m_symbols[i].st_name, name) == 0)
            return true;
        if (entry & 1)
            return false;
    }
}

bool Module::holds_function(const ElfW(Rela) & entry) {
    const auto type = uint32_t(ELF64_R_TYPE(entry.r_info));
    return type == type_jump_slot || type == type_glob_dat || type == type_absolute;
}

} // namespace ddt::elf

#endif
