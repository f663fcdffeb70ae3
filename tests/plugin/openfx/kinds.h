// SPDX-License-Identifier: Apache-2.0
// Hosts as they describe themselves. The numbers and names are those that users of these versions
// have published; what no effect asks for is left out.
#pragma once

#include <ostream>

#include "tests/plugin/openfx/mini_host.h"

namespace mini {

inline const std::set<std::string> usual_suites = {
    "OfxPropertySuite", "OfxImageEffectSuite", "OfxParameterSuite", "OfxMemorySuite",
    "OfxMessageSuite",  "OfxProgressSuite",    "OfxTimeLineSuite",  "OfxMultiThreadSuite"};

/// Nuke 10: floats only, and no RGB.
inline const Kind nuke = {"uk.co.thefoundry.nuke",
                          "1.2",
                          {"OfxImageEffectContextFilter", "OfxImageEffectContextGeneral"},
                          {"OfxImageComponentRGBA", "OfxImageComponentAlpha",
                           "uk.co.thefoundry.OfxImageComponentMotionVectors",
                           "uk.co.thefoundry.OfxImageComponentStereoDisparity"},
                          {"OfxBitDepthFloat"},
                          1,
                          1,
                          {{"OfxImageEffectPropTemporalClipAccess", 1},
                           {"OfxImageEffectPropSupportsOverlays", 1},
                           {"OfxImageEffectPropMultipleClipDepths", 0},
                           {"OfxImageEffectPropSupportsMultipleClipPARs", 0},
                           {"OfxParamHostPropSupportsParametricAnimation", 0},
                           {"OfxParamHostPropSupportsChoiceAnimation", 1}},
                          usual_suites,
                          {"OfxPropPluginDescription"},
                          {},
                          true,
                          false};

/// Natron 2.1.
inline const Kind natron = {"fr.inria.Natron",
                            "1.4",
                            {"OfxImageEffectContextGenerator", "OfxImageEffectContextFilter",
                             "OfxImageEffectContextGeneral", "OfxImageEffectContextTransition"},
                            {"OfxImageComponentRGBA", "OfxImageComponentAlpha",
                             "OfxImageComponentRGB",
                             "uk.co.thefoundry.OfxImageComponentMotionVectors",
                             "uk.co.thefoundry.OfxImageComponentStereoDisparity"},
                            {"OfxBitDepthFloat", "OfxBitDepthShort", "OfxBitDepthByte"},
                            1,
                            1,
                            {{"OfxImageEffectPropTemporalClipAccess", 1},
                             {"OfxImageEffectPropSupportsOverlays", 1},
                             {"OfxImageEffectPropMultipleClipDepths", 1},
                             {"OfxImageEffectPropSupportsMultipleClipPARs", 1},
                             {"OfxParamHostPropSupportsParametricAnimation", 0},
                             {"OfxParamHostPropSupportsChoiceAnimation", 1},
                             {"NatronOfxHostIsNatron", 1}},
                            usual_suites,
                            {},
                            {},
                            true,
                            false};

/// Resolve Lite 12.5: one size, whole images.
inline const Kind resolve = {
    "DaVinciResolveLite",
    "1.3",
    {"OfxImageEffectContextFilter", "OfxImageEffectContextGeneral",
     "OfxImageEffectContextTransition", "OfxImageEffectContextGenerator"},
    {"OfxImageComponentRGBA", "OfxImageComponentAlpha"},
    {"OfxBitDepthFloat", "OfxBitDepthShort", "OfxBitDepthByte"},
    0,
    0,
    {{"OfxImageEffectPropTemporalClipAccess", 1},
     {"OfxImageEffectPropSupportsOverlays", 1},
     {"OfxImageEffectPropMultipleClipDepths", 0},
     {"OfxImageEffectPropSupportsMultipleClipPARs", 0},
     {"OfxParamHostPropSupportsParametricAnimation", 0},
     {"OfxParamHostPropSupportsChoiceAnimation", 0}},
    usual_suites,
    {"OfxPropPluginDescription", "OfxImageEffectInstancePropSequentialRender"},
    {"OfxParamTypeInteger2D", "OfxParamTypeInteger3D"},
    false,
    true};

/// Catalyst Edit 2015.1.
inline const Kind catalyst = {
    "com.sony.Catalyst.Edit",
    "1.3",
    {"OfxImageEffectContextGeneral", "OfxImageEffectContextGenerator",
     "OfxImageEffectContextFilter", "OfxImageEffectContextTransition",
     "OfxImageEffectContextRetimer", "OfxImageEffectContextPaint"},
    {"OfxImageComponentNone", "OfxImageComponentRGBA", "OfxImageComponentAlpha"},
    {"OfxBitDepthByte", "OfxBitDepthShort", "OfxBitDepthHalf", "OfxBitDepthFloat"},
    0,
    0,
    {{"OfxImageEffectPropTemporalClipAccess", 1},
     {"OfxImageEffectPropSupportsOverlays", 0},
     {"OfxImageEffectPropMultipleClipDepths", 0},
     {"OfxImageEffectPropSupportsMultipleClipPARs", 0},
     {"OfxParamHostPropSupportsParametricAnimation", 0},
     {"OfxParamHostPropSupportsChoiceAnimation", 1},
     {"OfxParamHostPropMaxParameters", 1000}},
    {"OfxPropertySuite", "OfxImageEffectSuite", "OfxParameterSuite", "OfxMemorySuite",
     "OfxMessageSuite", "OfxProgressSuite", "OfxMultiThreadSuite"},
    {},
    {},
    true,
    false};

/// For the names of tests.
inline void PrintTo(const Kind& kind, std::ostream* out) {
    *out << kind.name;
}

/// Of API 1.0, with nothing that may be left out.
inline const Kind bare = {"bare",
                          "1.0",
                          {"OfxImageEffectContextFilter"},
                          {"OfxImageComponentRGBA"},
                          {"OfxBitDepthByte"},
                          0,
                          0,
                          {},
                          {"OfxPropertySuite", "OfxImageEffectSuite", "OfxParameterSuite"},
                          {"OfxPropPluginDescription", "OfxPropShortLabel", "OfxPropLongLabel",
                           "OfxImageEffectPluginPropSingleInstance"},
                          {"OfxParamTypeInteger2D", "OfxParamTypeInteger3D"},
                          false,
                          true};

} // namespace mini
