// SPDX-License-Identifier: Apache-2.0
// Callbacks that progress passes on its way to the caller's.
#pragma once

#include <algorithm>

#include "ddt/progress.h"

namespace ddt {

/// For work that is the part of the whole from the share `from` to the share `to`. Empty if `whole`
/// is, which must stay where it is.
inline ProgressCallback part_of(const ProgressCallback& whole, float from, float to) {
    if (!whole)
        return {};
    return [&whole, from, to](float share) {
        return whole(share < 1 ? std::min(from + share * (to - from), to) : to);
    };
}

/// `whole`, told the largest share so far: what is left of flips may grow again. Empty if `whole`
/// is, which must stay where it is.
inline ProgressCallback never_falling(const ProgressCallback& whole) {
    if (!whole)
        return {};
    return [&whole, most = 0.0f](float share) mutable {
        most = std::max(most, share);
        return whole(most);
    };
}

/// `whole` until it says false or throws; then false, and it is not called again, whichever thread
/// asks. One thread at a time. Empty if `whole` is, which must stay where it is.
inline ProgressCallback until_it_ends(const ProgressCallback& whole) {
    if (!whole)
        return {};
    return [&whole, going = true](float share) mutable {
        if (!going)
            return false;
        going = false; // should it throw
        going = whole(share);
        return going;
    };
}

} // namespace ddt
