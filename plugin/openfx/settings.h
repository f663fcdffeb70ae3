// SPDX-License-Identifier: Apache-2.0
// The effect's parameters: their definition, and their values at a time.
#pragma once

#include <string>

#include "plugin/openfx/abi.h"

namespace ddt::ofx {

struct Settings {
    double scale_x = 2, scale_y = 2;
    int width = 0, height = 0;             ///< in pixels; 0: by the scale, or from the other
    double centre_x = 0.5, centre_y = 0.5; ///< of the zoom: 0 to 1 from the lower left
    std::string filter;                    ///< a specification with all options
    std::string light;                     ///< one of host::meaning_names()
    int premultiplication = 0;             ///< an index of premultiplications
};

/// What colour and alpha have to do with each other.
enum Premultiplication { as_the_image_says, premultiplied, unpremultiplied };

/// Define all of them; `zoom`: for a host whose effects cannot change the size.
void define_parameters(ParamSet set, bool zoom);

/// ok, or what the host said of the first value that it has but could not hand out: others than the
/// user's would make another picture.
int settings_at(Effect effect, double time, Settings& settings);

} // namespace ddt::ofx
