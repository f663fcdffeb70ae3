// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

#include <dlfcn.h>
#include <link.h>

#include <gtest/gtest.h>

#include "plugin/register/got.h"
#include "tests/plugin/register/answer.h"

namespace {

int replacement() {
    return 43;
}
int other_replacement() {
    return 44;
}

ddt::got::Redirect to(int (*f)()) {
    return {"answer", reinterpret_cast<void*>(&answer), reinterpret_cast<void*>(f)};
}

/// call_answer() of a library that is loaded by this call.
CallAnswer* load(const char* path, int flags = 0) {
    void* library = dlopen(path, RTLD_LAZY | RTLD_LOCAL | flags);
    EXPECT_NE(library, nullptr) << dlerror();
    return library ? reinterpret_cast<CallAnswer*>(dlsym(library, "call_answer")) : nullptr;
}

/// Like "r--p": how the page at an address is mapped.
std::string protection(const void* address) {
    std::ifstream maps("/proc/self/maps");
    const auto wanted = reinterpret_cast<uintptr_t>(address);
    for (std::string line; std::getline(maps, line);) {
        unsigned long begin = 0, end = 0;
        char access[5] = "";
        if (std::sscanf(line.c_str(), "%lx-%lx %4s", &begin, &end, access) == 3 &&
            wanted >= begin && wanted < end)
            return access;
    }
    return "not mapped";
}

/// A redirect holds until the process ends: one for all tests.
class Got : public testing::Test {
protected:
    static void SetUpTestSuite() {
        lazy = load(DDT_LAZY_CALLER);
        eager = load(DDT_EAGER_CALLER);
        // A plugin with a library of its own, which its calls reach before those of the program.
        copy = load(DDT_COPY_CALLER, RTLD_DEEPBIND);
        symbol_table = protection(symbol());
        const ddt::got::Redirect redirect = to(replacement);
        report = ddt::got::redirect(&redirect, 1);
        late = load(DDT_LATE_CALLER);
    }

    static const void* symbol() {
        Dl_info info;
        ElfW(Sym)* entry = nullptr;
        dladdr1(reinterpret_cast<void*>(&answer_from_within), &info,
                reinterpret_cast<void**>(&entry), RTLD_DL_SYMENT);
        return entry;
    }

    inline static CallAnswer *lazy, *eager, *late, *copy;
    inline static std::string symbol_table;
    inline static ddt::got::Report report;
};

TEST_F(Got, ReportsWhatItChanged) {
    // The bound caller's slot, and within the defining library that of its own call and the
    // pointer.
    EXPECT_EQ(report.slots, 3);
    EXPECT_EQ(report.own_slots, 2);
    EXPECT_EQ(report.exports, 1);
    EXPECT_EQ(report.refused, 0);
    EXPECT_EQ(report.missed, 0);
    EXPECT_EQ(report.last_missed, nullptr);
}

TEST_F(Got, LeavesAnotherCopyOfTheLibraryAloneAndSaysSo) {
    ASSERT_NE(copy, nullptr);
    EXPECT_EQ(copy(), 42); // bound by this call
    EXPECT_EQ(copy(), 42);
    EXPECT_EQ(report.others, 1);
    ASSERT_NE(report.other, nullptr);
    EXPECT_NE(std::string(report.other).find("libgot_copy.so"), std::string::npos) << report.other;
}

TEST_F(Got, LeavesTheModuleOfTheReplacementAlone) {
    EXPECT_EQ(answer(), 42);
}

TEST_F(Got, RedirectsCallsWithinTheDefiningLibrary) {
    EXPECT_EQ(answer_from_within(), 43);
}

TEST_F(Got, RedirectsStoredPointers) {
    EXPECT_EQ(answer_by_pointer(), 43);
}

TEST_F(Got, RedirectsBoundCalls) {
    ASSERT_NE(eager, nullptr);
    EXPECT_EQ(eager(), 43);
}

TEST_F(Got, RedirectsCallsNotBoundYet) {
    ASSERT_NE(lazy, nullptr);
    EXPECT_EQ(lazy(), 43);
    EXPECT_EQ(lazy(), 43);
}

TEST_F(Got, RedirectsModulesLoadedLater) {
    ASSERT_NE(late, nullptr);
    EXPECT_EQ(late(), 43);
}

TEST_F(Got, RedirectsLookUpsByName) {
    void* found = dlsym(RTLD_DEFAULT, "answer");
    EXPECT_EQ(found, reinterpret_cast<void*>(&replacement));
}

TEST_F(Got, KeepsPagesProtected) {
    EXPECT_EQ(protection(pointer_address()), "r--p");
    EXPECT_EQ(protection(symbol()), symbol_table);
    EXPECT_EQ(symbol_table.find('w'), std::string::npos);
}

TEST_F(Got, LeavesWhatIsRedirectedAlone) {
    const ddt::got::Redirect redirect = to(other_replacement);
    const ddt::got::Report second = ddt::got::redirect(&redirect, 1);
    EXPECT_EQ(second.slots, 0);
    EXPECT_EQ(second.exports, 0);
    EXPECT_EQ(second.missed, 1);
    EXPECT_STREQ(second.last_missed, "answer");
    EXPECT_EQ(answer_from_within(), 43);
}

TEST_F(Got, RefusesWhatNoLibraryExports) {
    const ddt::got::Redirect redirect = {"replacement", reinterpret_cast<void*>(&replacement),
                                         reinterpret_cast<void*>(&other_replacement)};
    EXPECT_STREQ(ddt::got::redirect(&redirect, 1).last_missed, "replacement");
    EXPECT_EQ(replacement(), 43);
}

TEST(GotEmpty, TakesAnEmptyList) {
    const ddt::got::Report none = ddt::got::redirect(nullptr, 0);
    EXPECT_EQ(none.slots, 0);
    EXPECT_EQ(none.missed, 0);
}

} // namespace
