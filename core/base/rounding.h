// SPDX-License-Identifier: Apache-2.0
// How floats are rounded.
#pragma once

#include <cfenv>

namespace ddt {

/// While it lives this thread rounds to nearest, whatever its caller has set.
class RoundsToNearest {
public:
    RoundsToNearest() : m_saved(std::fegetround()) { set(FE_TONEAREST); }
    ~RoundsToNearest() { set(m_saved); }
    RoundsToNearest(const RoundsToNearest&) = delete;
    RoundsToNearest& operator=(const RoundsToNearest&) = delete;

private:
    void set(int mode) const {
        if (m_saved != FE_TONEAREST)
            std::fesetround(mode);
    }
    int m_saved;
};

} // namespace ddt
