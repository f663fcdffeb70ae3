// SPDX-License-Identifier: Apache-2.0
// Images with holes.
#pragma once

#include <string>

#include "ddt/resize.h"

namespace ddt {

/// Make `filled` the image, in this type, with its holes filled by options.mesh, whatever
/// options.holes says; leave it uninitialised where there are none, and options.progress is not
/// called. False with one line in `error`.
bool fill_image(const OIIO::ImageBuf& src, const Options& options, Holes holes, OIIO::TypeDesc type,
                OIIO::ImageBuf& filled, int nthreads, std::string& error);

/// The type for that where pixels are worked on afterwards: halfs are not rounded in between,
/// unless channels have types of their own, IDs among them. Integers stay integers, by which their
/// light is known.
OIIO::TypeDesc type_between(const OIIO::ImageBuf& src);

/// Make dst a copy of src with its holes filled so.
bool copy_filled(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options,
                 Holes holes, int nthreads, std::string& error);

} // namespace ddt
