// SPDX-License-Identifier: Apache-2.0
// The light of colour spaces that OpenColorIO's configs know.
//
// It is the scene-linear version of the space's own primaries: the config's way from the space to
// its scene_linear role, less the matrix between the primaries. What is left is a curve a channel
// for nearly all spaces, and nothing at all for linear ones. A space that is more than that (a 3D
// table, a rendering) goes to scene_linear itself, pixel by pixel through OpenColorIO. Where
// that loses colours, or tone maps those of a display, the light is the space's own (own_light.h).
#pragma once

#include <memory>
#include <string>

#include "plugin/colour/light.h"

namespace ddt {

/// What is said before the lights that there are, where an option names none of them.
constexpr char allowed_lights_text[] = "; allowed are auto";

/// The light of an image whose metadata names the space `image_space` (may be empty), under the
/// option light=`option`; under light=encoded as for auto, the caller then does not convert. Null
/// with one line in `error` when there is none, or when the option names a space whose colours do
/// not come back from their light; of an image's own space Light::comes_back() tells. What was
/// found of the last 32 spaces is kept. Thread-safe.
std::shared_ptr<const Light> find_light(const std::string& option, const std::string& image_space,
                                        std::string& error);

} // namespace ddt
