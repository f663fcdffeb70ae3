// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/threads.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "core/base/parallel.h"

namespace ddt::tool {
namespace {

int attribute(const char* name) {
    int value = -7;
    OIIO::getattribute(name, value);
    return value;
}

class Threads : public ::testing::Test {
protected:
    ~Threads() override {
        OIIO::attribute("threads", m_threads);
        OIIO::attribute("exr_threads", m_exr);
    }

private:
    const int m_threads = attribute("threads"), m_exr = attribute("exr_threads");
};

TEST_F(Threads, AskedForAreThoseOfOpenImageIOToo) {
    EXPECT_EQ(share_threads(1), 1);
    EXPECT_EQ(attribute("threads"), 1);
    EXPECT_EQ(attribute("exr_threads"), -1);
    EXPECT_EQ(share_threads(5), 5);
    EXPECT_EQ(attribute("exr_threads"), 5);
}

TEST_F(Threads, PlannedAreThoseOfAJobWhichChangeNothing) {
    for (const int attribute_threads : {1, attribute("threads")})
        for (const int wanted : {0, 1}) {
            OIIO::attribute("threads", attribute_threads);
            const int exr = attribute("exr_threads"), planned = planned_threads(wanted);
            EXPECT_EQ(attribute("threads"), attribute_threads);
            EXPECT_EQ(attribute("exr_threads"), exr);
            EXPECT_EQ(planned, share_threads(wanted));
        }
}

TEST_F(Threads, MoreThanThereAreCoresWork) {
    const int cores = usual_threads(), many = cores + 14;
    ASSERT_EQ(share_threads(many), many);
    EXPECT_EQ(share_threads(many + 1), many + 1);
    std::vector<int> done(size_t(many), 0);
    for_each_index(many, 100 * many, [&](int slot, int) {
        ++done[size_t(slot)];
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    EXPECT_GT(many - std::count(done.begin(), done.end(), 0), cores);
}

TEST_F(Threads, OfTheAttributeMayBeMoreThanThereAreCoresToo) {
    const int many = usual_threads() + 21; // more than other tests ask for: limits never fall
    OIIO::attribute("threads", many);
    EXPECT_EQ(planned_threads(0), many);
    OIIO::attribute("threads", many + 1);
    EXPECT_EQ(share_threads(0), many + 1);
}

TEST_F(Threads, TwoAreEnoughForTiffToCompressSideBySide) {
    EXPECT_EQ(share_threads(2), 2);
    EXPECT_EQ(attribute("threads"), 3);
}

TEST_F(Threads, OfNobodysAskingAreTheAttributes) {
    OIIO::attribute("threads", 1);
    const int exr = attribute("exr_threads");
    EXPECT_EQ(share_threads(0), 1);
    EXPECT_EQ(attribute("exr_threads"), exr);
}

} // namespace
} // namespace ddt::tool
