// SPDX-License-Identifier: Apache-2.0
// A library linked with -Bsymbolic-functions.
#include <gtest/gtest.h>

#include "plugin/register/got.h"
#include "tests/plugin/register/answer.h"

namespace {

int replacement() {
    return 43;
}

TEST(Symbolic, OwnCallsAreNotReachedAndThatIsReported) {
    const ddt::got::Redirect redirect = {"answer", reinterpret_cast<void*>(&answer),
                                         reinterpret_cast<void*>(&replacement)};
    const ddt::got::Report report = ddt::got::redirect(&redirect, 1);
    EXPECT_EQ(report.exports, 1);
    EXPECT_EQ(report.own_slots, 0);
    EXPECT_EQ(answer_from_within(), 42);
}

} // namespace
