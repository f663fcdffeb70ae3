// SPDX-License-Identifier: Apache-2.0
// The encodings that need no config, for hosts that have none: the curves of the bundled config
// (bundled_config.h), under its names and with the bits that OpenColorIO finds for them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/colour/light.h"

namespace ddt {

/// Light is number^gamma; with an offset it is ((number + offset) / (1 + offset))^gamma, and near 0
/// the straight line that goes over into it smoothly: IEC 61966-2-1, ITU-R BT.709. Below 0 the
/// curve's point reflection.
struct Encoding {
    const char* name;
    double gamma, offset;
};

/// The encoding of that name (in any case), or null.
const Encoding* encoding_of(std::string_view name);

/// The light of numbers encoded so, or null if there is no encoding of that name (in any case).
/// Made once and kept. Thread-safe. Throws std::bad_alloc.
std::shared_ptr<const Light> find_encoding(std::string_view name);

/// "linear", "sRGB", "Rec709", "Gamma1.8", "Gamma2.2", "Gamma2.4".
std::vector<std::string> encoding_names();

} // namespace ddt
