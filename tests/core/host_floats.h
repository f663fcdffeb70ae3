// SPDX-License-Identifier: Apache-2.0
// Ways in which a host may have floats computed while it calls this library.
#pragma once

#include <cfenv>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace ddt::test {

/// By <cfenv>, and on x86-64 by the register, of which std::fegetround() knows nothing there.
struct HostMode {
    int rounding = FE_TONEAREST;
    unsigned control = 0; ///< of MXCSR; 0: as it is
};

inline std::vector<HostMode> host_modes() {
    std::vector<HostMode> all = {{FE_UPWARD}, {FE_DOWNWARD}, {FE_TOWARDZERO}};
#if defined(__SSE2__)
    // Rounded down, up and towards zero; denormals as zero, as -ffast-math has them; and all that
    // is invalid, overflows or is divided by zero trapped.
    for (const unsigned control : {0x3f80u, 0x5f80u, 0x7f80u, 0x9fc0u, 0x1900u})
        all.push_back({FE_TONEAREST, control});
    // The x87 otherwise than the register.
    all.push_back({FE_UPWARD, 0x1f80u});
    all.push_back({FE_UPWARD, 0x3f80u});
#endif
    return all;
}

/// While it lives this thread computes so.
class HostFloats {
public:
    explicit HostFloats(const HostMode& mode) : m_mode(mode) {
        std::fegetenv(&m_saved);
        std::fesetround(mode.rounding);
#if defined(__SSE2__)
        if (mode.control)
            _mm_setcsr(mode.control);
#endif
    }
    ~HostFloats() {
        std::fesetenv(&m_saved);
    }
    HostFloats(const HostFloats&) = delete;
    HostFloats& operator=(const HostFloats&) = delete;

    /// Whether it does still.
    bool unchanged() const {
#if defined(__SSE2__)
        if (m_mode.control && (_mm_getcsr() & ~0x3fu) != m_mode.control)
            return false;
#endif
        return std::fegetround() == m_mode.rounding;
    }

private:
    HostMode m_mode;
    std::fenv_t m_saved;
};

} // namespace ddt::test
