// SPDX-License-Identifier: Apache-2.0
// What hosts of every kind do with the effect, in the order and with the suites they have.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <thread>

#include "tests/plugin/openfx/effect_fixture.h"

namespace {

using namespace mini;
using ddt::ofx::missing_host_feature;
using ddt::ofx::ok;
using ddt::ofx::reply_default;

const std::string contexts[] = {"OfxImageEffectContextFilter",     "OfxImageEffectContextGeneral",
                                "OfxImageEffectContextGenerator",  "OfxImageEffectContextPaint",
                                "OfxImageEffectContextTransition", "OfxImageEffectContextRetimer"};
const char* const needed_suites[] = {"OfxPropertySuite", "OfxImageEffectSuite",
                                     "OfxParameterSuite"};

/// 0 for components that the effect does not know.
int channels_of(const std::string& components) {
    return components == "OfxImageComponentRGBA"    ? 4
           : components == "OfxImageComponentRGB"   ? 3
           : components == "OfxImageComponentAlpha" ? 1
                                                    : 0;
}

bool lists(const Properties& p, const char* name, const std::string& wanted) {
    for (const Value& value : p.values.at(name))
        if (std::get<std::string>(value) == wanted)
            return true;
    return false;
}

size_t threads_here() {
    const std::filesystem::directory_iterator tasks("/proc/self/task"), end;
    return size_t(std::distance(tasks, end));
}

/// The system lists a thread that was joined, as by the test before, for a moment more.
size_t threads_that_stay() {
    size_t fewest = threads_here();
    for (int tries = 0; tries < 20; ++tries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        fewest = std::min(fewest, threads_here());
    }
    return fewest;
}

class OfxHosts : public OpenFx, public testing::WithParamInterface<Kind> {
protected:
    /// A picture in the host's first components and depth, and its instance.
    ImageBuf open_usual(int width, int height) {
        depth = GetParam().depths.front();
        ImageBuf image = photograph(width, height, 4, type_of(depth));
        open(GetParam(), image, depth);
        return image;
    }
    /// What a host shows of twice the size, by the light of the numbers as they are.
    ImageBuf wanted_of(const ImageBuf& image, const ddt::Options& options) const {
        const int w = image.spec().width, h = image.spec().height;
        const ImageBuf large = images::enlarged(image, 2 * w, 2 * h, options);
        if (GetParam().multi_resolution)
            return large;
        const int x = w / 2, y = h / 2; // a zoom, its centre in the middle
        return OIIO::ImageBufAlgo::cut(large, OIIO::ROI(x, x + w, y, y + h));
    }
    /// In one piece where the host has no tiles.
    int step() const { return GetParam().tiles ? 31 : 100000; }
    std::string depth;
};

TEST_P(OfxHosts, OfferTheEffectInTheirContextsDepthsAndComponents) {
    open_usual(20, 16);
    const Kind& kind = GetParam();
    int common = 0;
    for (const std::string& context : kind.contexts)
        common += lists(effect->properties, "OfxImageEffectPropSupportedContexts", context);
    EXPECT_EQ(common, int(std::min<size_t>(2, kind.contexts.size())));
    for (const std::string& offered : kind.depths)
        EXPECT_TRUE(lists(effect->properties, "OfxImageEffectPropSupportedPixelDepths", offered));
    for (const auto& [name, clip] : effect->clips)
        for (const std::string& offered : kind.components)
            EXPECT_EQ(lists(clip, "OfxImageEffectPropSupportedComponents", offered),
                      channels_of(offered) > 0)
                << name << offered;
    // A host may ask for others all the same.
    for (const std::string& context : contexts) {
        const bool known = context == contexts[0] || context == contexts[1];
        Effect described(*host);
        Properties in;
        in.put("OfxImageEffectPropContext", context);
        EXPECT_EQ(host->act("OfxImageEffectActionDescribeInContext", &described, &in),
                  known ? int(ok) : int(missing_host_feature))
            << context;
        EXPECT_EQ(described.clips.size(), known ? 2u : 0u) << context;
        EXPECT_EQ(described.params.empty(), !known) << context;
    }
}

TEST_P(OfxHosts, GetTheFiltersBitsInTheirDepthsAndComponents) {
    for (const std::string& offered : GetParam().depths)
        for (const std::string& components : GetParam().components)
            for (const char* light : {"linear", "sRGB"}) {
                const int channels = channels_of(components);
                if (channels == 0 || (channels == 1 && light[0] == 's'))
                    continue;
                const ImageBuf image = photograph(60, 44, channels, type_of(offered));
                open(GetParam(), image, offered, 0, 0, channels == 4);
                effect->choose("light", light);
                render_whole(step());
                EXPECT_TRUE(same_pixels(effect->output, wanted_of(image, with_light(light))))
                    << offered << components << light;
            }
}

TEST_P(OfxHosts, SetNumbersAsFarAsTheirRangesGo) {
    const ImageBuf image = open_usual(40, 30);
    for (const auto& [name, value] :
         {std::pair("scale", 8.0), {"scale_y", 5.0}, {"iterations", 200.0}, {"meshes", 4.0}}) {
        effect->set(name, value);
        EXPECT_EQ(effect->params.at(name).value, value) << name;
    }
    const char* const sizes[] = {"width", "height"};
    for (const char* name : sizes)
        EXPECT_EQ(effect->params.count(name), GetParam().multi_resolution ? 1u : 0u);
}

TEST_P(OfxHosts, AreAskedForSuitesOfVersion1AndNoOthersThanTheOnesUsed) {
    open_usual(20, 16);
    for (const std::string& suite : host->asked)
        EXPECT_TRUE(suite == "OfxPropertySuite 1" || suite == "OfxImageEffectSuite 1" ||
                    suite == "OfxParameterSuite 1" || suite == "OfxProgressSuite 1" ||
                    suite == "OfxMessageSuite 1" || suite == "OfxMultiThreadSuite 1")
            << suite;
}

// A host that renders several frames at once says fewer than the machine has.
TEST_P(OfxHosts, SayHowManyThreadsEachRenderMayUse) {
    const ImageBuf image = open_usual(300, 200);
    for (const unsigned int cpus : {1u, 2u, 0u, ~0u}) {
        host->cpus = cpus;
        host->asked_for_cpus = 0;
        render_whole(step());
        EXPECT_TRUE(same_pixels(effect->output, wanted_of(image, with_light("linear")))) << cpus;
        EXPECT_EQ(host->asked_for_cpus > 0, GetParam().suites.count("OfxMultiThreadSuite") > 0);
    }
}

TEST_P(OfxHosts, WithoutASuiteThatIsNeededAreToldSo) {
    for (const char* suite : needed_suites) {
        Host without(GetParam(), DDT_OFX_BUNDLE);
        without.withheld = {suite};
        without.plugin().set_host(without.abi());
        EXPECT_EQ(without.act("OfxActionLoad"), missing_host_feature) << suite;
        Effect none(without);
        EXPECT_EQ(without.act("OfxActionDescribe", &none), ddt::ofx::failed) << suite;
        EXPECT_EQ(none.render({0, 0, 1, 1}), ddt::ofx::failed) << suite;
        EXPECT_EQ(without.act("OfxActionUnload"), ok) << suite;
        without.withheld.clear();
        EXPECT_EQ(without.act("OfxActionLoad"), ok) << suite;
    }
}

TEST_P(OfxHosts, WithoutAnyOtherSuiteGetTheSame) {
    for (const std::string& suite : usual_suites) {
        if (std::count(std::begin(needed_suites), std::end(needed_suites), suite))
            continue;
        const ImageBuf image = open_usual(40, 30);
        host->withheld = {suite};
        ASSERT_EQ(host->act("OfxActionLoad"), ok); // again, now without
        render_whole(step());
        EXPECT_TRUE(same_pixels(effect->output, wanted_of(image, with_light("linear")))) << suite;
        // A failure has to be told without the suite, too.
        effect->output.depth = "OfxBitDepthNone";
        EXPECT_EQ(effect->render({0, 0, 20, 10}), ddt::ofx::failed) << suite;
    }
}

/// Actions one after the other, and what each returns.
struct Order {
    const char* what;
    std::vector<std::pair<const char*, int>> steps;
};
const Order orders[] = {
    {"before Load",
     {{"OfxActionDescribe", ddt::ofx::failed},
      {"OfxActionCreateInstance", ddt::ofx::failed},
      {"OfxImageEffectActionRender", ddt::ofx::failed},
      {"OfxActionUnload", ok},
      {"OfxActionLoad", ok},
      {"OfxActionDescribe", ok}}},
    {"twice",
     {{"OfxActionLoad", ok},
      {"OfxActionLoad", ok},
      {"OfxActionDescribe", ok},
      {"OfxActionDescribe", ok},
      {"OfxActionUnload", ok},
      {"OfxActionUnload", ok}}},
    {"instances that were not described, ended twice",
     {{"OfxActionLoad", ok},
      {"OfxActionCreateInstance", ok},
      {"OfxImageEffectActionGetRegionOfDefinition", reply_default},
      {"OfxImageEffectActionGetRegionsOfInterest", reply_default},
      {"OfxImageEffectActionIsIdentity", reply_default},
      {"OfxImageEffectActionRender", ddt::ofx::failed},
      {"OfxActionDestroyInstance", ok},
      {"OfxActionDestroyInstance", ok}}},
    {"what the effect leaves to the host",
     {{"OfxActionLoad", ok},
      {"OfxImageEffectActionBeginSequenceRender", reply_default},
      {"OfxImageEffectActionEndSequenceRender", reply_default},
      {"OfxImageEffectActionGetClipPreferences", reply_default},
      {"OfxImageEffectActionGetFramesNeeded", reply_default},
      {"OfxImageEffectActionGetTimeDomain", reply_default},
      {"OfxActionBeginInstanceEdit", reply_default},
      {"OfxActionEndInstanceEdit", reply_default},
      {"OfxActionInstanceChanged", reply_default},
      {"OfxActionPurgeCaches", reply_default},
      {"OfxActionSyncPrivateData", reply_default},
      {"OfxCatalystImageEffectActionGetRegionOfDefinition", reply_default},
      {"OfxActionOfTheFuture", reply_default}}},
    {"after Unload, and from the beginning",
     {{"OfxActionLoad", ok},
      {"OfxActionDescribe", ok},
      {"OfxActionUnload", ok},
      {"OfxActionDescribe", ddt::ofx::failed},
      {"OfxImageEffectActionRender", ddt::ofx::failed},
      {"OfxActionLoad", ok},
      {"OfxActionDescribe", ok}}},
};

TEST_P(OfxHosts, MayCallActionsInAnyOrder) {
    for (const Order& order : orders) {
        SCOPED_TRACE(order.what);
        Host here(GetParam(), DDT_OFX_BUNDLE);
        here.plugin().set_host(nullptr);
        EXPECT_EQ(here.act("OfxActionUnload"), ok); // of whoever was here before
        EXPECT_EQ(here.act("OfxActionLoad"), missing_host_feature);
        here.plugin().set_host(here.abi());
        Effect effect_(here);
        Properties in, out;
        for (const auto& [action, status] : order.steps)
            EXPECT_EQ(here.act(action, &effect_, &in, &out), status) << action;
        EXPECT_EQ(here.progress_started, here.progress_ended);
        EXPECT_TRUE(out.values.empty());
    }
}

TEST_P(OfxHosts, OfNobody) {
    open_usual(20, 16);
    EXPECT_EQ(host->act("OfxActionDescribe"), reply_default);
    EXPECT_EQ(host->act("OfxImageEffectActionRender"), reply_default);
}

/// A render that a host may stop: its status, and whether the result is all there.
struct Stopped {
    int status;
    bool whole;
};

Stopped render_to_stop(Effect& effect, const ImageBuf& wanted) {
    effect.output = effect.source;
    effect.output.box = {0, 0, wanted.spec().width, wanted.spec().height};
    effect.output.allocate();
    const int status = effect.render(effect.output.box);
    EXPECT_EQ(effect.images_held, 0);
    EXPECT_EQ(effect.foreign_calls, 0);
    return {status, same_pixels(effect.output, wanted)};
}

TEST_P(OfxHosts, AbortWhenTheyLikeAndGoOn) {
    const ImageBuf image = open_usual(2400, 20); // ten tiles
    const ImageBuf wanted = wanted_of(image, with_light("linear"));
    effect->choose("device", "cpu");
    int stops = 0;
    for (int calls = 0; calls < 6; ++calls) {
        effect->abort_after = calls;
        const Stopped stopped = render_to_stop(*effect, wanted);
        // A host that aborted does not look at the result.
        EXPECT_EQ(stopped.status, ok) << calls;
        stops += !stopped.whole;
    }
    EXPECT_GT(stops, 0); // only the host's own thread asks, which may be late once
    effect->abort_after = -1;
    EXPECT_EQ(host->progress_started, host->progress_ended);
    EXPECT_TRUE(host->messages.empty()); // no failure
    render_whole(100000);
    EXPECT_TRUE(same_pixels(effect->output, wanted));
}

TEST_P(OfxHosts, StopByTheBarAndGoOn) {
    const ImageBuf image = open_usual(2400, 20); // ten tiles
    const ImageBuf wanted = wanted_of(image, with_light("linear"));
    effect->choose("device", "cpu");
    int stops = 0;
    for (int calls = 0; calls < 6; ++calls) {
        host->stop_after = calls;
        const Stopped stopped = render_to_stop(*effect, wanted);
        stops += stopped.status == ddt::ofx::failed;
        // A bar that is not there from the beginning, as Natron's, is no wish to stop. One that
        // stops at the end may find all done.
        if (calls == 0 || !stopped.whole) {
            EXPECT_EQ(stopped.status, calls == 0 ? ok : ddt::ofx::failed) << calls;
        }
        EXPECT_TRUE(stopped.whole || calls > 0);
    }
    EXPECT_EQ(stops > 0, host->progress_started > 0) << "nobody else can stop it";
    host->stop_after = -1;
    EXPECT_EQ(host->progress_started, host->progress_ended);
    EXPECT_TRUE(host->messages.empty());
    render_whole(100000);
    EXPECT_TRUE(same_pixels(effect->output, wanted));
}

TEST_P(OfxHosts, RenderOneInstanceFromTwoThreads) {
    const ImageBuf image = open_usual(300, 200);
    const ImageBuf wanted = wanted_of(image, with_light("linear"));
    const int w = wanted.spec().width, h = wanted.spec().height;
    effect->choose("device", "cpu"); // a GPU's thread stays
    effect->output = effect->source;
    effect->output.box = {0, 0, w, h};
    effect->output.allocate();
    const size_t before = threads_that_stay();
    std::thread other([&] { EXPECT_EQ(effect->render({0, 0, w, h / 2}), ok); });
    EXPECT_EQ(effect->render({0, h / 2, w, h}), ok);
    other.join();
    for (int tries = 0; threads_here() > before && tries < 1000; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(threads_here(), before);
    EXPECT_EQ(effect->bars_beside_others, 0);
    EXPECT_EQ(effect->bars, 0);
    EXPECT_TRUE(same_pixels(effect->output, wanted));
}

TEST_P(OfxHosts, RenderTwoInstancesAtOnce) {
    const ImageBuf image = open_usual(120, 90);
    ImageBuf wanted[2] = {wanted_of(image, with_light("linear")),
                          wanted_of(image, with_light("sRGB"))};
    Effect second(*host);
    second.describe();
    second.source = effect->source;
    second.source_region = effect->source_region;
    second.choose("light", "sRGB");
    Effect* const both[] = {effect.get(), &second};
    for (Effect* e : both) {
        e->choose("device", "cpu");
        e->output = e->source;
        e->output.box = {0, 0, wanted[0].spec().width, wanted[0].spec().height};
        e->output.allocate();
    }
    const auto render = [](Effect* e) { EXPECT_EQ(e->render(e->output.box), ok); };
    std::thread other(render, both[1]);
    render(both[0]);
    other.join();
    for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(same_pixels(both[i]->output, wanted[i])) << i;
        EXPECT_EQ(both[i]->images_held, 0) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, OfxHosts, testing::Values(nuke, natron, resolve, catalyst, bare),
                         [](const auto& kind) {
                             const std::string name = kind.param.name;
                             return name.substr(name.rfind('.') + 1);
                         });

} // namespace
