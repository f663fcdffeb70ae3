// SPDX-License-Identifier: Apache-2.0
// What the name of a virtual image, or a sidecar file, asks for.
//
//     photo.png.ddt?scale=4&filter=ddt-linear&light=encoded
//
// names the image photo.png enlarged; there need not be a file photo.png.ddt. If there is one, it
// is a sidecar, for programs that insist on a file: a text of at most 64 KiB,
//
//     # photo4x.ddt
//     photo.png
//     scale=4
//     filter=ddt-linear
//
// whose first line is the image's path, relative to the sidecar's folder, and whose further lines
// are options. Empty lines and lines that start with # do not count. Options after a sidecar's name
// come after its own.
//
// A warning to programs that open names or sidecars that come from others: the image's path may be
// absolute or climb by "..", so a sidecar reads any image that the process may read, and asks for
// any size that OpenImageIO's attribute "limits:imagesize_MB" allows. A file that is not a regular
// one is refused, so are addresses ("http://..."), and a request cannot name another request as its
// image. See SECURITY.md.
//
// Options: scale=FACTOR, or width= or height= in pixels of the display window, or both (one alone
// keeps the shape); filter=NAME, a filter specification, by default "ddt"; and the options of the
// filter. The last of several wins.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

#include "ddt/resize.h"

namespace ddt {

struct Request {
    std::string source; ///< path of the image to enlarge
    double scale = 0;   ///< 0: not given
    int width = 0;      ///< 0: not given
    int height = 0;     ///< 0: not given
    Options options;

    /// The windows of the result for those of the source: the display window keeps its origin and
    /// is scaled to the size asked for, the data window along with it, rounded outwards. False with
    /// one line in `error` for a size out of bounds.
    bool windows(const OIIO::ImageSpec& from, OIIO::ImageSpec& to, std::string& error) const;
};

/// True if the name, up to a question mark, has the extension ".ddt", in the sense that OIIO looks
/// for a reader by it. Calls nothing of OIIO.
bool is_request_name(const std::string& name) noexcept;

/// Read the request from a name for which is_request_name() holds; opens the sidecar if there is
/// one. False with one line in `error` that names the thing at fault and what is allowed.
bool parse_request(const std::string& name, Request& request, std::string& error);

} // namespace ddt
