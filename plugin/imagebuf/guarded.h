// SPDX-License-Identifier: Apache-2.0
// The boundary of the library: no exception passes it, no half-written image stays behind it.
#pragma once

#include <exception>
#include <new>
#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "plugin/colour/config.h"

namespace ddt {

/// Run `body(touched, error)`, which returns false with a line in `error` when it fails, and sets
/// `touched` to what it is about to write, before it does. On failure, or on an exception, a dst
/// that was not initialised is so again, in another the touched pixels are black, and the line,
/// after "ddt: ", is dst's error.
template <class Body>
bool guarded(OIIO::ImageBuf& dst, Body&& body) noexcept {
    std::string error;
    try {
        const bool fresh = !dst.initialized();
        OIIO::ROI touched;
        try {
            if (body(touched, error))
                return true;
        } catch (const std::bad_alloc&) {
            error = "out of memory";
        } catch (const std::exception& e) {
            error = e.what();
        }
        if (fresh)
            dst.reset();
        else if (touched.defined())
            OIIO::ImageBufAlgo::zero(dst, touched);
        const bool named = error.compare(0, 5, "ddt: ") == 0;
        dst.errorfmt("{}{}", named ? "" : "ddt: ", one_line(error)); // OpenImageIO's may be more
    } catch (...) {
        // Not even the message could be stored.
    }
    return false;
}

} // namespace ddt
