// SPDX-License-Identifier: Apache-2.0
// How a thread computes with floats while it works for this library, whatever its caller has set.
#pragma once

#include <cfenv>
#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace ddt {

/// While it lives, this thread computes as every thread begins: it rounds to nearest, keeps
/// denormals and traps nothing. A host may have set the processor's registers by hand, of which
/// std::fegetround() need not know: on x86-64 glibc's asks the x87 alone, and std::fesetround()
/// sets both. Takes next to no time where nothing is to be changed. On processors other than
/// x86-64 and AArch64 it sees to rounding alone.
class DefaultFloats {
public:
    DefaultFloats() : m_rounding(std::fegetround()) {
#if defined(__SSE2__)
        m_saved = _mm_getcsr();
#elif defined(__aarch64__)
        asm volatile("mrs %0, fpcr" : "=r"(m_saved));
#endif
        if (m_rounding != FE_TONEAREST)
            std::fesetround(FE_TONEAREST);
        if (!is_default()) {
#if defined(__SSE2__)
            _mm_setcsr(default_mode);
#elif defined(__aarch64__)
            asm volatile("msr fpcr, %0" ::"r"(default_mode));
#endif
        }
    }
    ~DefaultFloats() {
        if (m_rounding != FE_TONEAREST)
            std::fesetround(m_rounding);
        if (m_rounding != FE_TONEAREST || !is_default()) {
#if defined(__SSE2__)
            _mm_setcsr(m_saved);
#elif defined(__aarch64__)
            asm volatile("msr fpcr, %0" ::"r"(m_saved));
#endif
        }
    }
    DefaultFloats(const DefaultFloats&) = delete;
    DefaultFloats& operator=(const DefaultFloats&) = delete;

private:
#if defined(__SSE2__)
    static constexpr unsigned default_mode = 0x1f80;
    /// But for what has happened, the lowest six bits.
    bool is_default() const {
        return (m_saved & ~0x3fu) == default_mode;
    }
    unsigned m_saved;
#elif defined(__aarch64__)
    static constexpr uint64_t default_mode = 0;
    bool is_default() const {
        return m_saved == default_mode;
    }
    uint64_t m_saved;
#else
    static bool is_default() {
        return true;
    }
#endif
    int m_rounding;
};

/// While it lives, this thread treats denormal floats as zero, as GPUs do, rounds to nearest and
/// traps nothing, whatever its caller has set. Otherwise values below 1.2e-38 could differ between
/// devices. On processors other than x86-64 and AArch64 it does nothing: there, bits are promised
/// only where no operation meets or makes such a value. What is a little less than 2^-126 and would
/// be rounded to it is that on x86-64, and zero on AArch64, which looks before it rounds.
class DenormalsAreZero {
public:
#if defined(__SSE2__)
    DenormalsAreZero() : m_saved(_mm_getcsr()) {
        _mm_setcsr(0x9fc0u);
    }
    ~DenormalsAreZero() {
        _mm_setcsr(m_saved);
    }
#elif defined(__aarch64__)
    DenormalsAreZero() {
        asm volatile("mrs %0, fpcr" : "=r"(m_saved));
        asm volatile("msr fpcr, %0" ::"r"(uint64_t(1) << 24));
    }
    ~DenormalsAreZero() {
        asm volatile("msr fpcr, %0" ::"r"(m_saved));
    }
#else
    // Not defaulted: an object that is only there to live must not look unused.
    DenormalsAreZero() {}
#endif
    DenormalsAreZero(const DenormalsAreZero&) = delete;
    DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

private:
#if defined(__SSE2__)
    unsigned m_saved;
#elif defined(__aarch64__)
    uint64_t m_saved;
#endif
};

} // namespace ddt
