// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/request.h"
#include "plugin/openfx/actions.h"
#include "plugin/openfx/source_clip.h"
#include "plugin/openfx/suites.h"

namespace ddt::ofx {
namespace {

void set_rect(Properties p, const char* name, const RectD& r) {
    set(p, name, r.x1, 0);
    set(p, name, r.y1, 1);
    set(p, name, r.x2, 2);
    set(p, name, r.y2, 3);
}

Holes holes_of(const Settings& settings) {
    host::Enlargement work;
    std::string error;
    host::set_filter(settings.filter, "linear", work, error);
    return work.holes;
}

} // namespace

int region_of_definition(Effect effect, Properties in, Properties out) {
    SourceClip source;
    if (const int found = source.find(effect, in); found != ok)
        return found;
    // Of render scale 1, whatever the scale: canonical regions do not depend on it.
    const PixelScale& scale = source.at_full_scale;
    const Windows w = windows_of(source.region, scale, scale, source.settings, zooms());
    if (!w.bounded())
        return reply_default;
    set_rect(out, "OfxImageEffectPropRegionOfDefinition", to_region(w.place.full, scale));
    return ok;
}

int regions_of_interest(Effect effect, Properties in, Properties out) {
    SourceClip source;
    if (const int found = source.find(effect, in); found != ok)
        return found;
    RectD wanted{};
    double* const sides[] = {&wanted.x1, &wanted.y1, &wanted.x2, &wanted.y2};
    for (int i = 0; i < 4; ++i)
        *sides[i] = get(in, "OfxImageEffectPropRegionOfInterest", 0.0, i);
    const Windows w = source.windows();
    if (!w.bounded())
        return reply_default;
    const Rect pixels = w.needed(to_pixels(wanted, source.scale), holes_of(source.settings));
    if (pixels.empty())
        return reply_default;
    set_rect(out, "OfxImageClipPropRoI_Source", to_canonical(pixels, source.scale));
    return ok;
}

int is_identity(Effect effect, Properties in, Properties out) {
    SourceClip source;
    if (const int found = source.find(effect, in); found != ok)
        return found;
    const Windows w = source.windows();
    // Of what has no end nothing is made.
    const bool same = w.place.copies() && w.place.full == w.place.window &&
                      holes_of(source.settings) == Holes::keep;
    if (w.bounded() && !same)
        return reply_default;
    set(out, "OfxPropName", "Source");
    set(out, "OfxPropTime", source.time);
    return ok;
}

} // namespace ddt::ofx
