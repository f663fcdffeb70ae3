// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/sequence/frames.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <future>
#include <stdexcept>
#include <thread>
#include <tuple>

#include <dirent.h>
#include <dlfcn.h>

#include <gtest/gtest.h>

#include "plugin/tool/sequence/run_frames.h"
#include "plugin/tool/sequence/sequence.h"
#include "tests/resource_limit.h"
#include "tests/temporary.h"

namespace {

/// Of a folder, before readdir() fails on this thread; less than 0: it does not.
thread_local int names_until_error = -1;

} // namespace

/// In the C library's place, also for the C++ library.
extern "C" __attribute__((visibility("default"))) dirent* readdir(DIR* folder) {
    static const auto next = reinterpret_cast<dirent* (*)(DIR*)>(dlsym(RTLD_NEXT, "readdir"));
    if (names_until_error == 0) {
        errno = EIO;
        return nullptr;
    }
    if (names_until_error > 0)
        --names_until_error;
    return next(folder);
}

namespace ddt::tool {
namespace {

using Numbers = std::vector<int>;

TEST(Frames, OfSeveralPlacesTheLikeliestCounts) {
    for (const auto& [name, third] : {std::pair("sky@2x.%04d.png", "sky@2x.0003.png"),
                                      {"sky.%04d@2x.png", "sky.0003@2x.png"},
                                      {"take#3_t.####.png", "take#3_t.0003.png"},
                                      {"a@2x.###.exr", "a@2x.003.exr"},
                                      {"d#/a.@@.exr", "d#/a.03.exr"},
                                      {"%d.a.%02d.exr", "%d.a.03.exr"}})
        EXPECT_EQ(FrameName(name).name(3, ""), third);
}

TEST(Frames, Lists) {
    const auto frames = [](const char* text) {
        Numbers numbers;
        return parse_frames(text, numbers) ? numbers : Numbers{-999};
    };
    EXPECT_EQ(frames("7"), (Numbers{7}));
    EXPECT_EQ(frames("1-4"), (Numbers{1, 2, 3, 4}));
    EXPECT_EQ(frames("1-10x4"), (Numbers{1, 5, 9}));
    EXPECT_EQ(frames("3-1"), (Numbers{3, 2, 1}));
    EXPECT_EQ(frames("10-1x4"), (Numbers{10, 6, 2}));
    EXPECT_EQ(frames("-3--1,5,-1-1"), (Numbers{-3, -2, -1, 5, 0, 1}));
    // From the least int to the greatest: 4294967295 apart.
    for (const auto& [text, first, last] :
         {std::tuple("-2147483648-2147483647x5000", INT_MIN, INT_MIN + int64_t(858993) * 5000),
          {"2147483647--2147483648x5000", INT_MAX, INT_MAX - int64_t(858993) * 5000},
          {"-2147483648-2147483647x2147483647", INT_MIN, INT_MAX - 1}}) {
        const Numbers numbers = frames(text);
        EXPECT_EQ(numbers.front(), first) << text;
        EXPECT_EQ(numbers.back(), last) << text;
    }
    for (const char* wrong : {"", "x", "1-", "1-5x0", "1-5x", "1--", "1,,2", "1-5y2", "1 - 5",
                              "1-2000000", "1-600000,1-600000", "99999999999"})
        EXPECT_EQ(frames(wrong), (Numbers{-999})) << wrong;
}

TEST(Frames, Names) {
    EXPECT_EQ(FrameName("a.#.exr").name(7), "a.0007.exr");
    EXPECT_EQ(FrameName("a.##.exr").name(7), "a.07.exr");
    EXPECT_EQ(FrameName("a.######.exr").name(7), "a.000007.exr");
    EXPECT_EQ(FrameName("a.@@@.exr").name(12345), "a.12345.exr");
    EXPECT_EQ(FrameName("a.%05d.exr").name(-7), "a.-0007.exr");
    EXPECT_EQ(FrameName("a%d.exr").name(7), "a7.exr");
    EXPECT_EQ(FrameName("dir#/%V/a.%v.#.exr").name(7, "left"), "dir#/left/a.l.0007.exr");
    EXPECT_EQ(FrameName("a.%V_%V.exr").name(0, "right"), "a.right_right.exr");
    // Sixteen digits hold any number, and none is cut off.
    const FrameName long_one(std::string(60, '#'));
    EXPECT_EQ(long_one.name(7), "0000000000000007");
    EXPECT_EQ(long_one.name(-2147483647), "-000002147483647");
    EXPECT_FALSE(FrameName("dir#/a.exr").has_frame());
    EXPECT_FALSE(FrameName("100%.exr").has_frame());
}

TEST(Frames, ThoseThatAreThere) {
    const std::string folder = temporary("frames");
    std::filesystem::create_directories(folder);
    for (const char* name : {"a.0001.exr", "a.0012.exr", "a.-003.exr", "a.12345.exr", "a.7.exr",
                             "a.00x1.exr", "b.0002.exr", "a.left.0004.exr", "a.0005.exr.txt"})
        std::ofstream(folder + "/" + name) << "";
    const auto there = [](const std::string& name, const std::vector<std::string>& views = {}) {
        Numbers frames;
        Failure failure;
        EXPECT_TRUE(FrameName(name).frames_there(views, frames, failure)) << failure.why;
        return frames;
    };
    EXPECT_EQ(there(folder + "/a.#.exr"), (Numbers{-3, 1, 12, 12345}));
    EXPECT_EQ(there(folder + "//a.#.exr"), (Numbers{-3, 1, 12, 12345}));
    EXPECT_EQ(there(folder + "/a.%V.#.exr", {"left", "right"}), (Numbers{4}));
    EXPECT_EQ(there("/no/such/folder/a.#.exr"), Numbers{});
    EXPECT_EQ(there(folder + "/b.0002.exr/a.#.exr"), Numbers{});
    // Digits of the name itself.
    std::ofstream(folder + "/shot_00122k.exr") << "";
    EXPECT_EQ(there(folder + "/shot_####2k.exr"), (Numbers{12}));
}

/// Why the frames of a name, perhaps of views, cannot be listed.
Failure unlisted(const std::string& in, const std::string& views) {
    std::vector<FrameTask> tasks;
    Failure failure{"", exit_done};
    const std::string out = temporary(views.empty() ? "unlisted.#.exr" : "unlisted.%V.#.exr");
    EXPECT_FALSE(list_tasks(in, out, "", views, tasks, failure));
    return failure;
}

TEST(Frames, AFolderThatCannotBeListedIsNotEmpty) {
    const std::string folder = temporary("unlisted");
    std::filesystem::create_directories(folder + "/left");
    std::ofstream(folder + "/left/a.0001.exr") << "";
    std::filesystem::create_symlink("right", folder + "/right"); // round and round
    const std::string loop =
        "cannot read folder \"" + folder + "/right/\": Too many levels of symbolic links";
    const Failure one = unlisted(folder + "/right/a.#.exr", ""),
                  two = unlisted(folder + "/%V/a.#.exr", "left,right");
    EXPECT_EQ(one.why, loop);
    EXPECT_EQ(one.code, exit_failed);
    EXPECT_EQ(two.why, loop);
    const test::ResourceLimit no_more(RLIMIT_NOFILE, 0);
    const Failure wanting = unlisted(folder + "/left/a.#.exr", "");
    EXPECT_EQ(wanting.why, "cannot read folder \"" + folder + "/left/\": Too many open files");
    EXPECT_EQ(wanting.code, exit_resources);
}

TEST(Frames, AFolderOfWhichAFurtherNameCannotBeReadIsNamed) {
    const std::string folder = temporary("unlisted further");
    std::filesystem::create_directories(folder);
    for (const char* name : {"a.0001.exr", "a.0002.exr", "a.0003.exr"})
        std::ofstream(folder + "/" + name) << "";
    names_until_error = 3;
    const Failure failure = unlisted(folder + "/a.#.exr", "");
    names_until_error = -1;
    EXPECT_EQ(failure.why, "cannot read folder \"" + folder + "/\": Input/output error");
    EXPECT_EQ(failure.code, exit_resources);
}

TEST(Frames, TextsOfAnyLengthAreLookedAt) {
    Numbers frames;
    EXPECT_FALSE(parse_frames(std::string(100000, '1'), frames));
    EXPECT_FALSE(parse_frames("1-" + std::string(100000, '1'), frames));
    EXPECT_FALSE(FrameName(std::string(100000, '#')).has_frame());
}

TEST(Frames, TasksOfACommandLine) {
    std::vector<FrameTask> tasks;
    Failure failure;
    ASSERT_TRUE(list_tasks("i.%V.#.exr", "o.%v.%03d.png", "1-2", "left,right", tasks, failure));
    ASSERT_EQ(tasks.size(), 4u);
    EXPECT_EQ(tasks[2].in, "i.left.0002.exr");
    EXPECT_EQ(tasks[3].out, "o.r.002.png");
    ASSERT_TRUE(list_tasks("i.%V.#.exr", "o.%V.#.exr", "1", " left, right ", tasks, failure));
    ASSERT_EQ(tasks.size(), 2u);
    EXPECT_EQ(tasks[0].in, "i.left.0001.exr");
    EXPECT_EQ(tasks[1].out, "o.right.0001.exr");
    struct Case {
        const char *in, *out, *frames, *views, *said;
        ExitCode code;
    };
    for (const Case& c : {Case{"i.exr", "o.#.exr", "1-2", "", "no place for the frame", exit_usage},
                          Case{"i.#.exr", "o.exr", "1-2", "", "no place for the frame", exit_usage},
                          Case{"f.#/i.exr", "o.#.exr", "1-2", "", "in its last part", exit_usage},
                          Case{"f.#/i.exr", "o.exr", "", "", "no file \"f.#/i.exr\"", exit_usage},
                          Case{"f.#/i.exr", "o.exr", "", "", "in its last part", exit_usage},
                          Case{"i@2x.png", "o.png", "", "", "no file \"i@2x.png\"", exit_usage},
                          Case{"i.#.exr", "o.#.exr", "1-", "", "1-100x2", exit_usage},
                          Case{"i.%V.exr", "o.%V.exr", "", "", "--views", exit_usage},
                          Case{"i.#.exr", "o.#.exr", "1", "left", "%V", exit_usage},
                          Case{"i.%V.exr", "o.%v.exr", "", "left,lower", "both become", exit_usage},
                          Case{"i.%V.exr", "o.%V.exr", "", "left,,right", "none", exit_usage},
                          Case{"i.%V.exr", "o.%V.exr", "", "left,", "left,right", exit_usage},
                          Case{"i.%V.exr", "o.%V.exr", "", " , ", "not allowed", exit_usage},
                          Case{"a%d.exr", "a1%d.exr", "1-12", "", "another's source", exit_usage},
                          Case{"x/%V.exr", "./x/%v.exr", "", "left,l", "source", exit_usage},
                          Case{"/none/i.#.exr", "o.#.exr", "", "", "no file", exit_failed}}) {
        EXPECT_FALSE(list_tasks(c.in, c.out, c.frames, c.views, tasks, failure));
        EXPECT_NE(failure.why.find(c.said), std::string::npos) << failure.why;
        EXPECT_EQ(failure.code, c.code);
    }
}

TEST(Frames, AFolderThatIsThereMayHaveAnyName) {
    const std::string folder = temporary("a#folder");
    EXPECT_TRUE(is_sequence(folder + "/i.exr", "", ""));
    std::filesystem::create_directory(folder);
    EXPECT_FALSE(is_sequence(folder + "/i.exr", "", ""));
    // What is not there in it is no number's place, unless it is called so itself.
    EXPECT_FALSE(is_sequence(folder + "/gone/i.exr", "", ""));
    EXPECT_TRUE(is_sequence(folder + "/gone#/i.exr", "", ""));
    // Its links lead round and round, so nobody knows whether it is there.
    std::filesystem::create_symlink("round#", folder + "/round#");
    EXPECT_FALSE(is_sequence(folder + "/round#/i.exr", "", ""));
}

TEST(Frames, FoldersOfViewsMayHaveAnyName) {
    const std::string folder = temporary("take#2");
    for (const char* view : {"left", "right"}) {
        std::filesystem::create_directories(folder + "/" + view);
        std::filesystem::create_directories(temporary(view) + "/take#2");
    }
    std::vector<FrameTask> tasks;
    Failure failure;
    for (const auto& [in, second] : {std::pair("take#2/%V/i.png", "take#2/right/i.png"),
                                     {"%V/take#2/i.png", "right/take#2/i.png"}}) {
        ASSERT_TRUE(
            list_tasks(temporary(in), temporary("o.%V.png"), "", "left,right", tasks, failure))
            << failure.why;
        ASSERT_EQ(tasks.size(), 2u);
        EXPECT_EQ(tasks[1].in, temporary(second));
    }
}

TEST(Frames, FilesAreToldApartWhateverTheirFoldersAreCalled) {
    const std::string folder = temporary("one folder"), link = temporary("a link");
    std::filesystem::create_directory(folder);
    std::filesystem::create_directory_symlink(folder, link);
    std::vector<FrameTask> tasks;
    Failure failure;
    EXPECT_FALSE(list_tasks(folder + "/f.%d.png", link + "/f.%d0.png", "1,10", "", tasks, failure));
    EXPECT_NE(failure.why.find("another's source"), std::string::npos) << failure.why;
    EXPECT_EQ(failure.code, exit_usage);
    EXPECT_TRUE(list_tasks(folder + "/f.%d.png", link + "/f.%d.png", "1,10", "", tasks, failure))
        << failure.why;
    // Two names of one folder.
    std::filesystem::create_directory_symlink(folder, temporary("l"));
    std::filesystem::create_directory_symlink(folder, temporary("m"));
    EXPECT_FALSE(list_tasks(temporary("%V.png"), temporary("%V/f.png"), "", "l,m", tasks, failure));
    EXPECT_NE(failure.why.find("both become"), std::string::npos) << failure.why;
    // Where a link leads on from is not where its name stands.
    const std::string beyond = temporary("one folder/beyond");
    std::filesystem::create_directory(temporary("far"));
    std::filesystem::create_directory_symlink(temporary("far"), beyond);
    EXPECT_TRUE(
        list_tasks(folder + "/f.%d.png", beyond + "/../f.%d0.png", "1,10", "", tasks, failure))
        << failure.why;
}

TEST(Frames, FilesAreToldApartWhateverLinksLeadToThem) {
    const std::string folder = temporary("linked") + "/", other = temporary("linked too") + "/";
    std::filesystem::create_directory(folder);
    std::filesystem::create_directory(other);
    for (const char* name : {"s.1", "s.2", "hold.1"})
        std::ofstream(folder + name) << name;
    const auto refused = [&](const std::string& in, const std::string& out) {
        std::vector<FrameTask> tasks;
        Failure failure;
        if (list_tasks(folder + in, folder + out, "1-2", "", tasks, failure))
            return std::string();
        EXPECT_EQ(failure.code, exit_usage);
        return failure.why;
    };
    const auto link = [&](const std::string& to, const std::string& name) {
        std::filesystem::create_symlink(to, folder + name);
    };
    link("s.2", "o.1");
    EXPECT_NE(refused("s.%d", "o.%d").find("another's source"), std::string::npos);
    link("hold.1", "hold.2");
    EXPECT_NE(refused("s.%d", "hold.%d").find("both become"), std::string::npos);
    EXPECT_NE(refused("hold.%d", "hold.%d").find("both become"), std::string::npos);
    // A held frame is a source like any other.
    EXPECT_EQ(refused("hold.%d", "new.%d"), "");
    // By way of a second link, and to what is not there yet.
    link("../linked too/p.1", "p.1");
    std::filesystem::create_symlink("../linked/s.2", other + "p.1");
    EXPECT_NE(refused("s.%d", "p.%d").find("another's source"), std::string::npos);
    link("none.1", "q.1");
    link("none.1", "q.2");
    EXPECT_NE(refused("s.%d", "q.%d").find("both become"), std::string::npos);
    // The source is a link to what another becomes.
    link("r.2", "t.1");
    EXPECT_NE(refused("t.%d", "r.%d").find("another's source"), std::string::npos);
    link("/dev/null", "v.1");
    link("/dev/null", "v.2");
    EXPECT_EQ(refused("s.%d", "v.%d"), "");
    // One that leads to the frame's own source replaces that.
    link("s.1", "own.1");
    link("s.2", "own.2");
    EXPECT_EQ(refused("s.%d", "own.%d"), "");
}

TEST(Frames, OnlyWhatIsDoneIsSaidToBeDone) {
    const std::vector<FrameTask> tasks = {{"first", ""}, {"second", ""}};
    FrameRun frames;
    frames.run = [](const FrameTask& task, const ProgressCallback& progress, Failure& failure) {
        progress(1);
        failure.why = "second fails";
        return task.in == "first";
    };
    const auto said = [&](bool keep_going, int failed) {
        frames.keep_going = keep_going;
        testing::internal::CaptureStderr();
        Progress progress("frames", ProgressMode::lines);
        EXPECT_EQ(run_frames(tasks, frames, progress).failed, failed);
        return testing::internal::GetCapturedStderr();
    };
    const std::string stopped = said(false, 1), went_on = said(true, 1);
    EXPECT_NE(stopped.find("ddt progress 95% frames"), std::string::npos) << stopped;
    EXPECT_EQ(stopped.find("100%"), std::string::npos) << stopped;
    EXPECT_NE(went_on.find("ddt progress 100% frames"), std::string::npos) << went_on;
}

TEST(Frames, OnesThatAreThereAreLeftOutIfTheyAreWhatWouldBeMade) {
    const std::string there = temporary("frame that is there");
    std::ofstream(there) << "made";
    const std::vector<FrameTask> tasks = {
        {"made so", there}, {"made otherwise", there}, {"not", ""}};
    FrameRun frames;
    frames.skip_existing = true;
    std::vector<std::string> run;
    frames.run = [&](const FrameTask& task, const ProgressCallback&, Failure&) {
        run.push_back(task.in);
        return true;
    };
    Progress progress("frames", ProgressMode::none);
    using Names = std::vector<std::string>;
    EXPECT_EQ(run_frames(tasks, frames, progress).skipped, 2);
    EXPECT_EQ(run, Names{"not"});
    run.clear();
    frames.is_made = [](const FrameTask& task) { return task.in == "made so"; };
    EXPECT_EQ(run_frames(tasks, frames, progress).skipped, 1);
    EXPECT_EQ(run, (Names{"made otherwise", "not"}));
    run.clear();
    frames.is_made = [](const FrameTask&) -> bool { throw std::runtime_error("no threads"); };
    EXPECT_EQ(run_frames(tasks, frames, progress).skipped, 0);
    // What keeps a place, or is no file, is no frame.
    frames.is_made = nullptr;
    std::ofstream(there, std::ios::trunc).flush();
    const std::string folder = temporary("folder of a frame's name");
    std::filesystem::create_directory(folder);
    EXPECT_EQ(run_frames({{"a", there}, {"b", folder}}, frames, progress).skipped, 0);
}

TEST(Frames, WhatIsThrownWhileMemoryIsCountedIsNoEnd) {
    std::vector<FrameTask> tasks(8);
    FrameRun frames;
    frames.jobs = 3;
    frames.keep_going = true;
    frames.memory_of = [](const FrameTask&) -> int64_t { throw std::runtime_error("no threads"); };
    frames.run = [](const FrameTask&, const ProgressCallback&, Failure&) { return true; };
    Progress progress("frames", ProgressMode::none);
    EXPECT_EQ(run_frames(tasks, frames, progress).written, 8);
}

TEST(Frames, OneThatIsWaitedForKeepsNoOther) {
    const std::vector<FrameTask> tasks = {{"first", ""}, {"slow", ""}, {"third", ""}, {"last", ""}};
    FrameRun frames;
    frames.jobs = 2;
    std::promise<void> others_done;
    std::atomic<int> done{0};
    std::atomic<bool> in_time{false};
    frames.memory_of = [&](const FrameTask& task) -> int64_t {
        // As the opening of a file on a file system that hangs.
        if (task.in == "slow")
            in_time = others_done.get_future().wait_for(std::chrono::seconds(60)) ==
                      std::future_status::ready;
        return 0;
    };
    frames.run = [&](const FrameTask& task, const ProgressCallback& progress, Failure&) {
        progress(0.5f);
        if (task.in != "slow" && ++done == 3)
            others_done.set_value();
        return true;
    };
    Progress progress("frames", ProgressMode::none);
    EXPECT_EQ(run_frames(tasks, frames, progress).written, 4);
    EXPECT_TRUE(in_time);
}

/// Run frames that take so much memory each; returns how many were worked on at once, at most.
int most_at_once(int64_t memory) {
    FrameRun frames;
    frames.jobs = 4;
    std::atomic<int> now{0}, most{0};
    frames.memory_of = [&](const FrameTask&) { return memory; };
    frames.run = [&](const FrameTask&, const ProgressCallback&, Failure&) {
        const int here = ++now;
        for (int before = most; here > before && !most.compare_exchange_weak(before, here);) {
        }
        for (int i = 0; i < 200; ++i) // others may come, if they are let
            std::this_thread::yield();
        --now;
        return true;
    };
    Progress progress("frames", ProgressMode::none);
    EXPECT_EQ(run_frames(std::vector<FrameTask>(30), frames, progress).written, 30);
    return most;
}

TEST(Frames, NoMoreAtATimeThanHaveMemory) {
    EXPECT_LE(most_at_once(memory_allowed() / 2), 2);
    EXPECT_EQ(most_at_once(memory_allowed() / 2 + 1), 1);
    EXPECT_EQ(most_at_once(memory_allowed() * 2), 1); // each alone
}

TEST(Frames, TheCodeIsThatOfWantIfOneFailedForIt) {
    const std::vector<FrameTask> tasks = {{"first", ""}, {"second", ""}, {"third", ""}};
    for (const bool first : {false, true}) {
        FrameRun frames;
        frames.keep_going = true;
        frames.run = [&](const FrameTask& task, const ProgressCallback&, Failure& failure) {
            failure = {task.in, (task.in == "first") == first ? exit_resources : exit_failed};
            return task.in == "third";
        };
        testing::internal::CaptureStderr();
        Progress progress("frames", ProgressMode::none);
        const FrameCounts counts = run_frames(tasks, frames, progress);
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "ddt: first\nddt: second\n");
        EXPECT_EQ(counts.failed, 2);
        EXPECT_EQ(counts.code, exit_resources) << first;
    }
}

} // namespace
} // namespace ddt::tool
