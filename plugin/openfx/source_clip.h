// SPDX-License-Identifier: Apache-2.0
// What every action starts with: the time, the source clip, the scales, the settings.
#pragma once

#include "plugin/openfx/suites.h"
#include "plugin/openfx/windows.h"

namespace ddt::ofx {

struct SourceClip {
    Clip clip = nullptr;
    double time = 0;
    RectD region{}; ///< of definition, canonical
    PixelScale scale, at_full_scale;
    Settings settings;
    /// That it has no region at this time, as clipGetRegionOfDefinition() then says.
    bool is_black = false;

    /// ok; reply_default where the host has no such clip or region; else what an action returns
    /// that cannot go on.
    int find(Effect effect, Properties in);
    Windows windows() const;
};

} // namespace ddt::ofx
