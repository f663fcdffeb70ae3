// SPDX-License-Identifier: Apache-2.0
// An image whose pixels come while it is worked on.
#pragma once

#include <string>

#include "ddt/rect.h"

namespace ddt {

/// Knows which rows of an image are there, and what it has no room for.
class Arrival {
public:
    virtual ~Arrival() = default;
    /// Wait until the rows above `end`, which is one of the image's or its end, have come. False
    /// with one line in `error` when they never will. Thread-safe.
    virtual bool wait_for(int end, std::string& error) = 0;
    /// Put into the floats that were read of all channels of the pixels of `r`, row by row, what
    /// the image could not hold of them. Thread-safe.
    virtual void complete(const Rect& /*r*/, float* /*pixels*/) const {}
};

} // namespace ddt
