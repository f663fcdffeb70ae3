// SPDX-License-Identifier: Apache-2.0
// Memory for images: what is allowed, and taking it.
#pragma once

#include <cstdint>
#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// Bytes that this process may have: the machine's memory, or what its control groups allow of it.
int64_t available_memory();

/// What is said, besides more, of an image that another machine may have the memory for.
inline constexpr char machine_memory_text[] = "this machine's memory";

/// False with one line in `error` unless an image of `roi`'s size may be allocated: coordinates
/// within +-largest_coordinate, and no more bytes than OpenImageIO's attribute
/// "limits:imagesize_MB" or available_memory() allows.
bool check_size(const OIIO::ROI& roi, int channels, OIIO::TypeDesc format, std::string& error);
/// The same of so many bytes for something else: "comparing 640 x 480 pixels".
bool check_memory(const std::string& what, double bytes, std::string& error);

/// Make `image` one as `spec` says, its pixels not yet written. False with one line in `error` when
/// there is no memory: OpenImageIO 3 then calls an image initialised that has no pixels.
bool take_memory(OIIO::ImageBuf& image, const OIIO::ImageSpec& spec, std::string& error);

/// The same with black pixels.
bool make_image(OIIO::ImageBuf& image, const OIIO::ImageSpec& spec, std::string& error);

} // namespace ddt
