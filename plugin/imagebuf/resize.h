// SPDX-License-Identifier: Apache-2.0
// resize() of ddt/resize.h where pixels of the source are still coming.
#pragma once

#include "ddt/resize.h"
#include "plugin/image/arrival.h"

namespace ddt {

/// Whether a display window that becomes another is enlarged by the mesh alone: an axis grows and
/// none shrinks.
inline bool enlarges(const OIIO::ROI& from, const OIIO::ROI& to) {
    return to.width() >= from.width() && to.height() >= from.height() &&
           (to.width() > from.width() || to.height() > from.height());
}

/// resize() of ddt/resize.h, if there is an arrival while pixels of src are coming, which is then
/// not dst. What a mesh is not made of is not completed.
bool resize_arriving(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, Arrival* arrival,
                     const Options& options, OIIO::ROI roi, int nthreads);

} // namespace ddt
