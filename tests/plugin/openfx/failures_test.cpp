// SPDX-License-Identifier: Apache-2.0
// What the effect does where a call of the host's fails.
#include "plugin/openfx/actions.h"
#include "tests/plugin/openfx/effect_fixture.h"

namespace {

using namespace mini;

constexpr int unknown_error = 3; // kOfxStatErrUnknown
constexpr int errors[] = {unknown_error, ddt::ofx::out_of_memory, ddt::ofx::bad_handle};

class OpenFxFailures : public OpenFx {
protected:
    /// An instance, and an output of twice the source's size.
    void open_with_output(int width = 40, int height = 30) {
        open(nuke, photograph(width, height, 3, TypeDesc::FLOAT));
        effect->choose("device", "cpu");
        effect->output = effect->source;
        effect->output.box = {0, 0, 2 * width, 2 * height};
        effect->output.allocate();
    }
    int render_all() { return effect->render(effect->output.box); }
    /// The status of each action but render that looks at the source.
    std::vector<int> statuses_of_regions() {
        RectD region{};
        Properties in, out;
        return {effect->region_of_definition(region),
                effect->region_of_interest({0, 0, 10, 10}, region),
                host->act("OfxImageEffectActionIsIdentity", effect.get(), &in, &out)};
    }
    /// Nothing was written, held or told; and a host that stopped the render hears of no failure.
    void expect_failure(int status) {
        const std::vector<char> untouched = effect->output.bytes;
        EXPECT_EQ(render_all(), status);
        effect->abort_after = 0;
        EXPECT_EQ(render_all(), ddt::ofx::ok);
        effect->abort_after = -1;
        EXPECT_EQ(effect->output.bytes, untouched);
        EXPECT_EQ(effect->images_held, 0);
        EXPECT_TRUE(host->messages.empty());
    }
};

/// Only of one that does not exist at that time the standard says that it is black.
TEST_F(OpenFxFailures, AnImageThatCouldNotBeHadIsNotBlack) {
    for (const int error : errors) {
        SCOPED_TRACE(error);
        open_with_output();
        effect->source_status = error;
        expect_failure(ddt::ofx::failure(error));
    }
    for (const int error : {int(ddt::ofx::failed), errors[0], errors[1], errors[2]}) {
        SCOPED_TRACE(error);
        open_with_output();
        effect->output_status = error;
        expect_failure(ddt::ofx::failure(error));
    }
}

TEST_F(OpenFxFailures, ARegionThatCouldNotBeHadIsNotBlack) {
    for (const int error : errors) {
        SCOPED_TRACE(error);
        open_with_output();
        effect->region_status = error;
        expect_failure(ddt::ofx::failure(error));
        EXPECT_EQ(statuses_of_regions(), std::vector<int>(3, ddt::ofx::failure(error)));
    }
    open_with_output();
    effect->region_status = ddt::ofx::failed;
    EXPECT_EQ(statuses_of_regions(), std::vector<int>(3, ddt::ofx::reply_default));
}

/// Another filter, or another size, would go into a film as if it were the user's.
TEST_F(OpenFxFailures, AValueThatCouldNotBeHadIsNotTheInitialOne) {
    for (const char* name : {"scale", "width", "filter", "light", "premultiplication", "meshes"})
        for (const int error : {int(ddt::ofx::failed), errors[0], errors[1], errors[2]}) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(error));
            open_with_output();
            effect->params.at(name).status = error;
            expect_failure(ddt::ofx::failure(error));
            EXPECT_EQ(statuses_of_regions(), std::vector<int>(3, ddt::ofx::failure(error)));
        }
}

/// A parameter that the host refused to define, or lost.
TEST_F(OpenFxFailures, AParameterThatIsNotThereIsTheInitialOne) {
    open_with_output();
    ASSERT_EQ(render_all(), ddt::ofx::ok);
    const std::vector<char> usual = effect->output.bytes;
    for (const char* name : {"scale", "width", "filter", "meshes"}) {
        effect->params.erase(name);
        effect->output.allocate();
        EXPECT_EQ(render_all(), ddt::ofx::ok) << name;
        EXPECT_EQ(effect->output.bytes, usual) << name;
    }
}

/// It is the user's wish alone that stops the work.
TEST_F(OpenFxFailures, ABarThatFailsIsLeftAloneAndTheWorkGoesOn) {
    open_with_output(900, 900); // 16 tiles
    host->cpus = 1;             // all worked on where the bar is asked
    ASSERT_EQ(render_all(), ddt::ofx::ok);
    const std::vector<char> usual = effect->output.bytes;
    for (const int error : {int(ddt::ofx::failed), errors[0], errors[2], 14})
        for (const int good : {0, 1}) { // updates before
            host->stop_after = good;
            host->stop_status = error;
            host->progress_updates = 0;
            effect->output.allocate();
            EXPECT_EQ(render_all(), ddt::ofx::ok) << error;
            EXPECT_EQ(effect->output.bytes, usual) << error;
            EXPECT_EQ(host->progress_updates, good + 1) << error;
        }
    EXPECT_EQ(host->progress_started, host->progress_ended);
    EXPECT_TRUE(host->messages.empty());
}

TEST(OpenFxFailure, OfMemoryIsToldApart) {
    EXPECT_EQ(ddt::ofx::failure(ddt::ofx::out_of_memory), 8);
    for (const int error : {1, 3, 9, 14})
        EXPECT_EQ(ddt::ofx::failure(error), 1);
}

} // namespace
