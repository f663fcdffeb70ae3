// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo's forms that return an image, made from those that write one.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include "plugin/message/format.h"
#include "plugin/register/hooks.h"

namespace ddt {

/// `call` does as F does, into an image that it returns; a failure is that image's error.
template <auto F>
struct Returning;

template <class... Args, bool (*F)(OIIO::ImageBuf&, const OIIO::ImageBuf&, Args...)>
struct Returning<F> {
    static OIIO::ImageBuf call(const OIIO::ImageBuf& src, Args... args) {
        OIIO::ImageBuf result;
        if (!F(result, src, args...) && !result.has_error())
            set_error(result, "ddt: the filter failed");
        return result;
    }
};

/// Redirect both forms of a function to F; `from` and `returning` are the function's name.
template <auto F>
void add_both(Redirects& list, const char* label, decltype(F) from,
              decltype(&Returning<F>::call) returning) {
    add(list, label, from, F);
    add(list, label, returning, &Returning<F>::call);
}

} // namespace ddt
