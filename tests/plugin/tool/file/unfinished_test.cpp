// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/unfinished.h"

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <thread>

#include <gtest/gtest.h>

#include "tests/child_process.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

namespace fs = std::filesystem;

/// The signal that ends a child process which does this.
template <class F>
int ended_by(F&& f) {
    const auto work = [&] {
        std::signal(SIGINT, SIG_DFL); // a shell's background jobs ignore it
        std::signal(SIGHUP, SIG_DFL); // and what nohup runs
        remove_unfinished_on_signals();
        f();
        return 0;
    };
    return test::in_child(work).signal;
}

TEST(Unfinished, ASignalBetweenTheMakingOfAFileAndItsListingWaits) {
    const std::string path = temporary("unfinished");
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGUSR2, SIGALRM, SIGIO})
        EXPECT_EQ(ended_by([&] {
                      const SignalsWait until_listed;
                      kill(getpid(), signal);
                      std::ofstream(path) << "half of it";
                      list_unfinished(path);
                  }),
                  signal);
    EXPECT_FALSE(fs::exists(path));
}

TEST(Unfinished, ASignalThatWasIgnoredIsIgnoredOn) {
    EXPECT_EQ(ended_by([] { raise(SIGHUP); }), SIGHUP);
    EXPECT_EQ(ended_by([] {
                  std::signal(SIGHUP, SIG_IGN); // as nohup does, before the program begins
                  remove_unfinished_on_signals();
                  raise(SIGHUP);
              }),
              0);
}

TEST(Unfinished, SoItDoesWhereAnotherThreadTakesIt) {
    const std::string path = temporary("unfinished in a thread");
    EXPECT_EQ(ended_by([&] {
                  std::thread maker([&] {
                      const SignalsWait until_listed;
                      kill(getpid(), SIGTERM); // for the first thread
                      usleep(20000);
                      std::ofstream(path) << "half of it";
                      list_unfinished(path);
                  });
                  maker.join();
                  pause();
              }),
              SIGTERM);
    EXPECT_FALSE(fs::exists(path));
}

TEST(Unfinished, ASecondSignalWaitsUntilTheFilesAreGone) {
    const std::string path = temporary("unfinished twice");
    for (const int signal : {SIGTERM, SIGRTMIN + 3}) {
        const int by = ended_by([&] {
            std::ofstream(path) << "half of it";
            list_unfinished(path);
            // Both are there when the first is let through.
            sigset_t these, before;
            sigfillset(&these);
            pthread_sigmask(SIG_BLOCK, &these, &before);
            kill(getpid(), signal);
            kill(getpid(), signal); // of real time it counts twice
            kill(getpid(), SIGINT);
            pthread_sigmask(SIG_SETMASK, &before, nullptr);
        });
        EXPECT_TRUE(by == signal || by == SIGINT) << by;
        EXPECT_FALSE(fs::exists(path)) << signal;
        fs::remove(path);
    }
}

TEST(Unfinished, IsRemovedWhereThereIsNoMemoryAndThatIsSaid) {
    const std::string path = temporary("unfinished without memory"), said = temporary("said");
    const auto end = [&] {
        if (!std::freopen(said.c_str(), "w", stderr))
            return 1;
        std::ofstream(path) << "half of it";
        list_unfinished(path);
        end_without_memory();
    };
    EXPECT_EQ(test::in_child(end).code, 3);
    EXPECT_EQ(text_in(said), "ddt: out of memory\n");
    EXPECT_FALSE(fs::exists(path));
}

TEST(EndsWithoutMemory, AsLongAsThereIsOne) {
    const std::new_handler before = std::get_new_handler();
    auto first = std::make_unique<EndsWithoutMemory>();
    const std::new_handler ends = std::get_new_handler();
    EXPECT_NE(ends, before);
    auto second = std::make_unique<EndsWithoutMemory>();
    first.reset(); // those of two threads go in any order
    EXPECT_EQ(std::get_new_handler(), ends);
    second.reset();
    EXPECT_EQ(std::get_new_handler(), before);
}

TEST(Unfinished, WhatIsNoLongerListedStays) {
    const std::string path = temporary("finished");
    EXPECT_EQ(ended_by([&] {
                  std::ofstream(path) << "all of it";
                  unlist_unfinished(list_unfinished(path));
                  raise(SIGTERM);
              }),
              SIGTERM);
    EXPECT_TRUE(fs::exists(path));
}

} // namespace
} // namespace ddt::tool
