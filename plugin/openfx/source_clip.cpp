// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/source_clip.h"

#include "plugin/openfx/actions.h"

namespace ddt::ofx {

int SourceClip::find(Effect effect, Properties in) {
    Properties p = nullptr;
    time = get(in, "OfxPropTime", 0.0);
    if (suites.effect->clip_get_handle(effect, "Source", &clip, &p) != ok)
        return reply_default;
    const int status = suites.effect->clip_get_region_of_definition(clip, time, &region);
    is_black = status == failed;
    if (status != ok)
        return is_black ? int(reply_default) : failure(status);
    if (!p)
        suites.effect->clip_get_property_set(clip, &p);
    const double aspect = p ? get(p, "OfxImagePropPixelAspectRatio", 1.0) : 1.0;
    at_full_scale = {aspect > 0 ? 1 / aspect : 1, 1};
    scale = {at_full_scale.x * get(in, "OfxImageEffectPropRenderScale", 1.0, 0),
             at_full_scale.y * get(in, "OfxImageEffectPropRenderScale", 1.0, 1)};
    const int had = settings_at(effect, time, settings);
    return had == ok ? had : failure(had);
}

Windows SourceClip::windows() const {
    return windows_of(region, scale, at_full_scale, settings, zooms());
}

} // namespace ddt::ofx
