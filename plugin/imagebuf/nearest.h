// SPDX-License-Identifier: Apache-2.0
// IDs, which are resized by the nearest pixels.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// Whether the roi's channels are IDs, all of them.
bool all_are_ids(const OIIO::ImageBuf& src, const OIIO::ROI& roi);

/// Resize those of the roi's channels that are IDs by the nearest pixels.
bool copy_nearest_ids(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                      std::string& error);

} // namespace ddt
