// SPDX-License-Identifier: Apache-2.0
// oiiotool's grammar of sizes, without that by corners.
#pragma once

#include <string>

namespace ddt::tool {

struct Size {
    int width = 0, height = 0;
    int x = 0, y = 0; ///< origin
};

constexpr const char* allowed_sizes =
    "WxH, Wx0 or 0xH (keeps the shape), WxH+X+Y, S%, W%xH%, S (a factor)";

/// What oiiotool's --resize makes of `text` for an image of size `from`:
///
///     640x480          that size; a 0 is computed from the other to keep the shape
///     640x480+10-20    and that origin
///     50%   50%x75%    of the size, rounded to whole pixels
///     2.5              the factor
///
/// False for anything else, two corners (0,0,639,479) too, and for a size that is not positive or
/// beyond 2^24.
bool parse_size(const std::string& text, const Size& from, Size& to);

/// Whether `text` is a size, for an image of some size.
bool is_size(const std::string& text);

/// The message about a text that is none.
std::string wrong_size(const std::string& text);

} // namespace ddt::tool
