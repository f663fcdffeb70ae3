// SPDX-License-Identifier: Apache-2.0
// An ImageBuf read off its mesh under any mapping.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/resize.h"
#include "plugin/image/arrival.h"

namespace ddt {

/// Write those pixels of `roi` that `mapping` gives, in the roi's channels, from src's mesh. Both
/// images have passed check_source() and prepare(). arrival: of src's pixels; null: all are there.
/// False with one line in `error`.
bool resample(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Mapping& mapping,
              const OIIO::ROI& roi, const Options& options, int nthreads, std::string& error,
              Arrival* arrival = nullptr);

/// Whether numbers of this type are cut off to 0 .. 1 (SurfaceOptions::clipped).
inline bool cuts_off(OIIO::TypeDesc type) {
    return type == OIIO::TypeUInt8 || type == OIIO::TypeUInt16;
}

} // namespace ddt
