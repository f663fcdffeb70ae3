// SPDX-License-Identifier: Apache-2.0
// The effect's own declarations of OpenFX against OpenFX's headers, where these are.
#include "plugin/openfx/abi.h"

#include <gtest/gtest.h>
#include <ofxCore.h>
#include <ofxImageEffect.h>
#include <ofxMessage.h>
#include <ofxMultiThread.h>
#include <ofxParam.h>
#include <ofxProgress.h>

namespace {

namespace ofx = ddt::ofx;

#define DDT_SAME_PLACE(mine, member, theirs, name)                                                 \
    EXPECT_EQ(offsetof(ofx::mine, member), offsetof(theirs, name)) << #member

TEST(OpenFxHeaders, FunctionsAreInTheirPlaces) {
    DDT_SAME_PLACE(PropertySuite, set_pointer, OfxPropertySuiteV1, propSetPointer);
    DDT_SAME_PLACE(PropertySuite, set_string, OfxPropertySuiteV1, propSetString);
    DDT_SAME_PLACE(PropertySuite, set_double, OfxPropertySuiteV1, propSetDouble);
    DDT_SAME_PLACE(PropertySuite, set_int, OfxPropertySuiteV1, propSetInt);
    DDT_SAME_PLACE(PropertySuite, get_pointer, OfxPropertySuiteV1, propGetPointer);
    DDT_SAME_PLACE(PropertySuite, get_string, OfxPropertySuiteV1, propGetString);
    DDT_SAME_PLACE(PropertySuite, get_double, OfxPropertySuiteV1, propGetDouble);
    DDT_SAME_PLACE(PropertySuite, get_int, OfxPropertySuiteV1, propGetInt);
    DDT_SAME_PLACE(PropertySuite, get_dimension, OfxPropertySuiteV1, propGetDimension);
    DDT_SAME_PLACE(EffectSuite, get_property_set, OfxImageEffectSuiteV1, getPropertySet);
    DDT_SAME_PLACE(EffectSuite, get_param_set, OfxImageEffectSuiteV1, getParamSet);
    DDT_SAME_PLACE(EffectSuite, clip_define, OfxImageEffectSuiteV1, clipDefine);
    DDT_SAME_PLACE(EffectSuite, clip_get_handle, OfxImageEffectSuiteV1, clipGetHandle);
    DDT_SAME_PLACE(EffectSuite, clip_get_property_set, OfxImageEffectSuiteV1, clipGetPropertySet);
    DDT_SAME_PLACE(EffectSuite, clip_get_image, OfxImageEffectSuiteV1, clipGetImage);
    DDT_SAME_PLACE(EffectSuite, clip_release_image, OfxImageEffectSuiteV1, clipReleaseImage);
    DDT_SAME_PLACE(EffectSuite, clip_get_region_of_definition, OfxImageEffectSuiteV1,
                   clipGetRegionOfDefinition);
    DDT_SAME_PLACE(EffectSuite, abort, OfxImageEffectSuiteV1, abort);
    DDT_SAME_PLACE(ParamSuite, define, OfxParameterSuiteV1, paramDefine);
    DDT_SAME_PLACE(ParamSuite, get_handle, OfxParameterSuiteV1, paramGetHandle);
    DDT_SAME_PLACE(ParamSuite, get_value_at_time, OfxParameterSuiteV1, paramGetValueAtTime);
    DDT_SAME_PLACE(ProgressSuite, start, OfxProgressSuiteV1, progressStart);
    DDT_SAME_PLACE(ProgressSuite, update, OfxProgressSuiteV1, progressUpdate);
    DDT_SAME_PLACE(ProgressSuite, end, OfxProgressSuiteV1, progressEnd);
    DDT_SAME_PLACE(MessageSuite, message, OfxMessageSuiteV1, message);
    DDT_SAME_PLACE(MultiThreadSuite, number_of_cpus, OfxMultiThreadSuiteV1, multiThreadNumCPUs);
    DDT_SAME_PLACE(Host, fetch_suite, OfxHost, fetchSuite);
    DDT_SAME_PLACE(Plugin, identifier, OfxPlugin, pluginIdentifier);
    DDT_SAME_PLACE(Plugin, set_host, OfxPlugin, setHost);
    DDT_SAME_PLACE(Plugin, main_entry, OfxPlugin, mainEntry);
}

TEST(OpenFxHeaders, NumbersAreTheirs) {
    EXPECT_EQ(int(ofx::ok), kOfxStatOK);
    EXPECT_EQ(int(ofx::failed), kOfxStatFailed);
    EXPECT_EQ(int(ofx::missing_host_feature), kOfxStatErrMissingHostFeature);
    EXPECT_EQ(int(ofx::out_of_memory), kOfxStatErrMemory);
    EXPECT_EQ(int(ofx::bad_handle), kOfxStatErrBadHandle);
    EXPECT_EQ(int(ofx::reply_no), kOfxStatReplyNo);
    EXPECT_EQ(int(ofx::reply_default), kOfxStatReplyDefault);
}

} // namespace
