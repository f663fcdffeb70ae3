// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/threads.h"

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
    const int many = allowed_threads(5);
    EXPECT_EQ(share_threads(5), many);
    EXPECT_EQ(attribute("exr_threads"), many);
}

TEST_F(Threads, TwoAreEnoughForTiffToCompressSideBySide) {
    const int two = allowed_threads(2);
    EXPECT_EQ(share_threads(2), two);
    EXPECT_EQ(attribute("threads"), two == 2 ? 3 : 1);
}

TEST_F(Threads, OfNobodysAskingAreTheAttributes) {
    OIIO::attribute("threads", 1);
    const int exr = attribute("exr_threads");
    EXPECT_EQ(share_threads(0), 1);
    EXPECT_EQ(attribute("exr_threads"), exr);
}

} // namespace
} // namespace ddt::tool
