// SPDX-License-Identifier: Apache-2.0
// The encodings that need no config, for hosts that have none: the curves of colour/carried.ocio,
// under its names and with the bits that OpenColorIO finds for them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/colour/light.h"

namespace ddt {

/// The light of numbers encoded so, or null if there is no encoding of that name (in any case).
/// Made once and kept. Thread-safe. Throws std::bad_alloc.
std::shared_ptr<const Light> find_encoding(std::string_view name);

/// "linear", "sRGB", "Rec709", "Gamma1.8", "Gamma2.2", "Gamma2.4".
std::vector<std::string> encoding_names();

} // namespace ddt
