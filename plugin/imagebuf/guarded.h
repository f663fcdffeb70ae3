// SPDX-License-Identifier: Apache-2.0
// The boundary of the library: no exception passes it, no half-written image stays behind it.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "core/base/guarded.h"
#include "core/base/one_line.h"
#include "plugin/image/cached_reads.h"
#include "plugin/image/ids.h"
#include "plugin/image/prepare.h"
#include "plugin/imagebuf/copy.h"
#include "plugin/message/format.h"

namespace ddt {

/// Run `body(touched, error)`, which returns false with a line in `error` when it fails, and sets
/// `touched` to what it is about to write, before it does. On failure, or on an exception, a dst
/// that was not initialised is so again, in another the touched pixels are black, and the line,
/// after "ddt: ", is dst's error.
template <class Body>
bool guarded(OIIO::ImageBuf& dst, Body&& body) noexcept {
    bool done = false;
    guarded_call(nullptr, [&] {
        const bool fresh = !dst.initialized(), pending = dst.has_error();
        OIIO::ROI touched;
        std::string error;
        const Caught caught = guarded_call(&error, [&] { done = body(touched, error); });
        done = done && caught == Caught::nothing;
        if (done)
            return;
        if (fresh)
            dst.reset();
        else if (touched.defined())
            OIIO::ImageBufAlgo::zero(dst, touched);
        if (!pending)
            dst.geterror(); // OpenImageIO's own words for it
        set_error(&error, error.empty() ? out_of_memory_text : std::string(error).c_str());
        set_error(dst, error);
    });
    return done;
}

/// The same with a source, which may be dst itself: `body(from, touched, error)` has its pixels
/// apart from dst's, with ids as exact as they were stored.
template <class Body>
bool guarded_from(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, Body&& body) noexcept {
    return guarded(dst, [&](OIIO::ROI& touched, std::string& error) {
        if (!check_source(src, error))
            return false;
        OIIO::ImageBuf copy, ids;
        const bool of_caller = src.storage() == OIIO::ImageBuf::APPBUFFER;
        if (&dst == &src && of_caller && !copy_whole(copy, src, src.spec().format, error))
            return false;
        if (&dst == &src && !of_caller)
            copy = src; // of a file in OpenImageIO's cache no pixels
        const OIIO::ImageBuf& from = &dst == &src ? copy : src;
        const CachedReads reads(from);
        return reads.all_well(error) && read_ids(from, ids, error) &&
               body(ids.initialized() ? ids : from, touched, error) && reads.all_well(error);
    });
}

} // namespace ddt
