// SPDX-License-Identifier: Apache-2.0
// An image whose pixels come while it is worked on.
#pragma once

#include <string>

namespace ddt {

/// Knows which rows of an image in local memory are there.
class Arrival {
public:
    virtual ~Arrival() = default;
    /// Wait until the rows above `end`, which is one of the image's or its end, have come. False
    /// with one line in `error` when they never will. Thread-safe.
    virtual bool wait_for(int end, std::string& error) = 0;
};

} // namespace ddt
