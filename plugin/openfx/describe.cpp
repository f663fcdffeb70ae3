// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/actions.h"
#include "plugin/openfx/settings.h"
#include "plugin/openfx/suites.h"

namespace ddt::ofx {

bool zooms() {
    return get(suites.host->host, "OfxImageEffectPropSupportsMultiResolution", 1) == 0;
}

int describe(Effect effect) {
    Properties p = nullptr;
    if (suites.effect->get_property_set(effect, &p) != ok)
        return failed;
    for (const char* label : {"OfxPropLabel", "OfxPropShortLabel", "OfxPropLongLabel"})
        set(p, label, "Enlarge (ddt)");
    set(p, "OfxImageEffectPluginPropGrouping", "Transform");
    set(p, "OfxPropPluginDescription",
        "Enlarges by data-dependent triangulation: edges stay smooth at any factor. The result has "
        "the bits of oiiotool --resize:filter=ddt.");
    set(p, "OfxImageEffectPropSupportedContexts", "OfxImageEffectContextFilter", 0);
    set(p, "OfxImageEffectPropSupportedContexts", "OfxImageEffectContextGeneral", 1);
    int depth = 0;
    for (const char* name :
         {"OfxBitDepthFloat", "OfxBitDepthHalf", "OfxBitDepthShort", "OfxBitDepthByte"})
        set(p, "OfxImageEffectPropSupportedPixelDepths", name, depth++);
    set(p, "OfxImageEffectPropSupportsTiles", 1);
    set(p, "OfxImageEffectPropSupportsMultiResolution", 1);
    set(p, "OfxImageEffectPropTemporalClipAccess", 0);
    set(p, "OfxImageEffectPluginPropSingleInstance", 0);
    set(p, "OfxImageEffectPluginPropHostFrameThreading", 0);
    set(p, "OfxImageEffectPluginRenderThreadSafety", "OfxImageEffectRenderFullySafe");
    return ok;
}

int describe_in_context(Effect effect, Properties in) {
    const std::string context = get(in, "OfxImageEffectPropContext", "");
    if (context != "OfxImageEffectContextFilter" && context != "OfxImageEffectContextGeneral")
        return missing_host_feature;
    for (const char* clip : {"Source", "Output"}) {
        Properties p = nullptr;
        if (suites.effect->clip_define(effect, clip, &p) != ok)
            return failed;
        int index = 0;
        for (const char* components :
             {"OfxImageComponentRGBA", "OfxImageComponentRGB", "OfxImageComponentAlpha"})
            set(p, "OfxImageEffectPropSupportedComponents", components, index++);
        set(p, "OfxImageEffectPropSupportsTiles", 1);
    }
    ParamSet parameters = nullptr;
    if (suites.effect->get_param_set(effect, &parameters) != ok)
        return failed;
    define_parameters(parameters, zooms());
    return ok;
}

} // namespace ddt::ofx
