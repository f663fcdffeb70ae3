// SPDX-License-Identifier: Apache-2.0
// Redirecting where the system does not let pages be made writable.
#include <gtest/gtest.h>

#include "plugin/register/got.h"
#include "tests/plugin/register/answer.h"
#include "tests/plugin/register/refuse_writable.h"

namespace {

int replacement() {
    return 43;
}

TEST(Refused, WhatCannotBeWrittenIsCountedAndStays) {
    const ddt::got::Redirect redirect = {"answer", reinterpret_cast<void*>(&answer),
                                         reinterpret_cast<void*>(&replacement)};
    refuse = true;
    const ddt::got::Report report = ddt::got::redirect(&redirect, 1);
    refuse = false;
    EXPECT_EQ(report.slots, 0);
    EXPECT_EQ(report.exports, 0);
    EXPECT_EQ(report.refused, 3); // the symbol, and in read-only data the own call's and a pointer
    EXPECT_EQ(answer_from_within(), 42);
    EXPECT_EQ(answer_by_pointer(), 42);
}

} // namespace
