// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/whole_file.h"

#include <sys/fsuid.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <tuple>

#include <gtest/gtest.h>

#include "plugin/tool/file/unfinished.h"
#include "tests/child_process.h"
#include "tests/resource_limit.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

namespace fs = std::filesystem;

class WholeFiles : public testing::Test {
protected:
    WholeFiles() {
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    std::string path(const std::string& name) const { return m_folder + "/" + name; }

    static void put(const std::string& path, const char* text) { std::ofstream(path) << text; }

    bool write(const std::string& path, const char* text) {
        WholeFile file;
        return file.open(path, m_failure) && std::fputs(text, file.file()) >= 0 &&
               file.commit(m_failure);
    }
    size_t files() const {
        size_t count = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(m_folder))
            ++count;
        return count;
    }

    Failure m_failure;

private:
    const std::string m_folder = temporary("whole");
};

TEST_F(WholeFiles, AppearWhenCommitted) {
    const std::string out = path("out.exr");
    put(out, "before");
    {
        WholeFile file;
        ASSERT_TRUE(file.open(out, m_failure)) << m_failure.why;
        EXPECT_EQ(fs::path(file.temporary()).parent_path(), fs::path(out).parent_path());
        EXPECT_EQ(fs::path(file.temporary()).extension(), ".exr");
        std::fputs("after", file.file());
        std::fflush(file.file());
        EXPECT_EQ(text_in(out), "before");
        ASSERT_TRUE(file.commit(m_failure)) << m_failure.why;
    }
    EXPECT_EQ(text_in(out), "after");
    EXPECT_EQ(files(), 1u);
}

TEST_F(WholeFiles, AreNothingWithoutCommit) {
    {
        WholeFile file;
        ASSERT_TRUE(file.open(path("out.exr"), m_failure));
        std::fputs("half", file.file());
    }
    EXPECT_EQ(files(), 0u);
}

TEST_F(WholeFiles, WhatAKilledProcessLeftIsRemoved) {
    const auto work = [&] {
        WholeFile file;
        if (file.open(path("out.exr"), m_failure))
            std::fputs("a longer text, left over", file.file());
        std::fflush(file.file());
        return raise(SIGKILL);
    };
    ASSERT_EQ(test::in_child(work).signal, SIGKILL);
    EXPECT_EQ(files(), 1u);
    EXPECT_FALSE(fs::exists(path("out.exr")));
    ASSERT_TRUE(write(path("out.exr"), "whole")) << m_failure.why;
    EXPECT_EQ(text_in(path("out.exr")), "whole");
    EXPECT_EQ(files(), 1u);
}

TEST_F(WholeFiles, WhatSeveralLeftIsRemovedAndWhatIsHeldIsNot) {
    WholeFile held;
    ASSERT_TRUE(held.open(path("out.exr"), m_failure)) << m_failure.why;
    const auto work = [&] {
        WholeFile killed[4];
        for (WholeFile& file : killed)
            file.open(path("out.exr"), m_failure);
        fs::remove(killed[1].temporary()); // one that was written meanwhile
        return raise(SIGKILL);
    };
    ASSERT_EQ(test::in_child(work).signal, SIGKILL);
    EXPECT_EQ(files(), 4u);
    ASSERT_TRUE(write(path("out.exr"), "whole")) << m_failure.why;
    EXPECT_EQ(files(), 2u);
    EXPECT_TRUE(fs::exists(held.temporary()));
    std::fputs("held", held.file());
    ASSERT_TRUE(held.commit(m_failure)) << m_failure.why;
    EXPECT_EQ(text_in(path("out.exr")), "held");
}

// As by NFS with root_squash, a user's files have an owner whose number is not the user's.
TEST_F(WholeFiles, WhatWasLeftIsKnownByTheOwnerThatFilesHaveThere) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can make files that are another's";
    constexpr uid_t mapped = 1234, stranger = 4321;
    fs::permissions(path("."), fs::perms::all);
    fs::permissions(temporary(""), fs::perms(0711));
    const auto leave = [&](int number, uid_t owner) {
        const std::string left = path(".out.ddt-" + std::to_string(number) + ".exr");
        put(left, "left over");
        ASSERT_EQ(chown(left.c_str(), owner, owner), 0);
        ASSERT_EQ(chmod(left.c_str(), 0666), 0);
    };
    leave(0, mapped);
    leave(1, stranger);
    leave(3, mapped);
    const auto work = [&] {
        setfsuid(mapped);
        return write(path("out.exr"), "whole") ? 0 : 1;
    };
    ASSERT_EQ(test::in_child(work).code, 0);
    EXPECT_EQ(text_in(path("out.exr")), "whole");
    EXPECT_TRUE(fs::exists(path(".out.ddt-1.exr")));
    EXPECT_EQ(files(), 2u);
}

TEST_F(WholeFiles, WhatSomebodyElseLeftIsNot) {
    const std::string first = path(".out.ddt-0.exr"), out = path("out.exr");
    const auto expect_untouched = [&](const char* what) {
        EXPECT_TRUE(write(out, "whole")) << what << ": " << m_failure.why;
        EXPECT_EQ(text_in(out), "whole") << what;
        EXPECT_TRUE(fs::exists(first)) << what;
        fs::remove(out);
        fs::remove(first);
    };
    put(path("precious"), "precious");
    fs::create_hard_link(path("precious"), first);
    expect_untouched("a file with another name");
    fs::create_symlink("precious", first);
    expect_untouched("a link");
    EXPECT_EQ(text_in(path("precious")), "precious");
    ASSERT_EQ(mkfifo(first.c_str(), 0666), 0);
    expect_untouched("a pipe");
    if (geteuid() == 0) {
        put(first, "");
        ASSERT_EQ(chown(first.c_str(), 1234, 1234), 0);
        expect_untouched("another's");
    }
}

TEST_F(WholeFiles, NamesThatAreAllTakenAreTold) {
    const auto name = [&](int i) { return path(".out.ddt-" + std::to_string(i) + ".exr"); };
    for (int i = 0; i < 100; ++i)
        fs::create_symlink("somebody's", name(i));
    EXPECT_FALSE(write(path("out.exr"), "whole"));
    EXPECT_EQ(m_failure.code, exit_resources);
    for (const std::string& told : {path("out.exr"), name(0), name(99)})
        EXPECT_NE(m_failure.why.find('"' + told + '"'), std::string::npos) << m_failure.why;
    EXPECT_EQ(files(), 100u);
    fs::remove(name(99));
    EXPECT_TRUE(write(path("out.exr"), "whole")) << m_failure.why;
}

TEST_F(WholeFiles, AreNoMoreReadableMeanwhileThanWhatTheyReplace) {
    const std::string out = path("out.exr");
    const auto rights = [](const std::string& of) { return fs::status(of).permissions(); };
    put(out, "before");
    fs::permissions(out, fs::perms(0600));
    WholeFile file;
    ASSERT_TRUE(file.open(out, m_failure)) << m_failure.why;
    EXPECT_EQ(rights(file.temporary()), fs::perms(0600));
    // It has the rights of what was there, even if that has gone.
    fs::permissions(out, fs::perms(0644));
    WholeFile other;
    ASSERT_TRUE(other.open(out, m_failure)) << m_failure.why;
    fs::remove(out);
    ASSERT_TRUE(other.commit(m_failure)) << m_failure.why;
    EXPECT_EQ(rights(out), fs::perms(0644));
}

TEST_F(WholeFiles, TwoAtOnceDoNotMix) {
    WholeFile a, b;
    ASSERT_TRUE(a.open(path("out.exr"), m_failure) && b.open(path("out.exr"), m_failure));
    EXPECT_NE(a.temporary(), b.temporary());
    std::fputs("first", a.file());
    std::fputs("second", b.file());
    ASSERT_TRUE(b.commit(m_failure) && a.commit(m_failure));
    EXPECT_EQ(text_in(path("out.exr")), "first");
    EXPECT_EQ(files(), 1u);
}

TEST_F(WholeFiles, ASignalRemovesThem) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGRTMIN, SIGRTMAX}) {
        const auto work = [&] {
            std::signal(signal, SIG_DFL); // a shell's background jobs ignore SIGINT
            remove_unfinished_on_signals();
            WholeFile file;
            return file.open(path("out.exr"), m_failure) ? raise(signal) : 0;
        };
        EXPECT_EQ(test::in_child(work).signal, signal);
        EXPECT_EQ(files(), 0u);
    }
}

/// Put another file under this name, as a run does that takes what is there for left over.
void replace_by_another(const std::string& path) {
    const std::string other = path + ".new";
    std::ofstream(other) << "another's";
    fs::rename(other, path);
}

TEST_F(WholeFiles, WhatAnotherPutInTheirPlaceIsNeitherTakenNorRemoved) {
    const std::string out = path("out.exr");
    put(out, "before");
    std::string name;
    {
        WholeFile committed, given_up;
        ASSERT_TRUE(committed.open(out, m_failure)) << m_failure.why;
        EXPECT_TRUE(committed.check_kept(m_failure));
        name = committed.temporary();
        std::fputs("mine", committed.file());
        replace_by_another(name);
        EXPECT_FALSE(committed.check_kept(m_failure));
        m_failure = {};
        EXPECT_FALSE(committed.commit(m_failure));
        EXPECT_EQ(m_failure.code, exit_resources);
        for (const std::string& told : {out, name})
            EXPECT_NE(m_failure.why.find('"' + told + '"'), std::string::npos) << m_failure.why;
        EXPECT_EQ(text_in(name), "another's");
        ASSERT_TRUE(given_up.open(path("other.exr"), m_failure)) << m_failure.why;
        replace_by_another(given_up.temporary());
    }
    EXPECT_EQ(text_in(out), "before");
    EXPECT_EQ(text_in(name), "another's");
    EXPECT_EQ(text_in(path(".other.ddt-0.exr")), "another's");
    EXPECT_EQ(files(), 3u);
}

TEST_F(WholeFiles, ThatVanishAreAFailureThatMayPass) {
    WholeFile file;
    ASSERT_TRUE(file.open(path("out.exr"), m_failure)) << m_failure.why;
    fs::remove(file.temporary());
    EXPECT_FALSE(file.commit(m_failure));
    EXPECT_EQ(m_failure.code, exit_resources);
    EXPECT_EQ(files(), 0u);
}

TEST_F(WholeFiles, ASignalDoesNotRemoveAnothers) {
    const auto work = [&] {
        remove_unfinished_on_signals();
        WholeFile file;
        if (!file.open(path("out.exr"), m_failure))
            return 0;
        replace_by_another(file.temporary());
        return raise(SIGTERM);
    };
    EXPECT_EQ(test::in_child(work).signal, SIGTERM);
    EXPECT_EQ(text_in(path(".out.ddt-0.exr")), "another's");
}

TEST_F(WholeFiles, AreTheirOwnersToWriteUntilTheyAreWholeWhateverTheMask) {
    const auto rights_of = [](const std::string& file) { return fs::status(file).permissions(); };
    for (const mode_t mask : {0222u, 0333u, 0777u}) {
        const std::string out = temporary("masked.tif"), old = temporary("masked and old.tif");
        fs::remove(out);
        std::ofstream(old) << "old";
        ASSERT_EQ(chmod(old.c_str(), 0440), 0);
        const mode_t before = umask(mask);
        for (const std::string& path : {out, old}) {
            WholeFile file;
            Failure failure;
            EXPECT_TRUE(file.open(path, failure)) << failure.why;
            EXPECT_EQ(rights_of(file.temporary()) & fs::perms(0600), fs::perms(0600));
            EXPECT_TRUE(file.commit(failure)) << failure.why;
        }
        umask(before);
        EXPECT_EQ(rights_of(out), fs::perms(0666 & ~mask));
        EXPECT_EQ(rights_of(old), fs::perms(0440));
    }
}

TEST_F(WholeFiles, KeepLinksAndPermissions) {
    put(path("real.exr"), "before");
    fs::permissions(path("real.exr"), fs::perms(0640));
    fs::create_symlink("real.exr", path("link.exr"));
    fs::create_symlink("later.exr", path("dangling.exr"));
    ASSERT_TRUE(write(path("link.exr"), "after")) << m_failure.why;
    EXPECT_TRUE(fs::is_symlink(path("link.exr")));
    EXPECT_EQ(text_in(path("real.exr")), "after");
    EXPECT_EQ(fs::status(path("real.exr")).permissions(), fs::perms(0640));
    ASSERT_TRUE(write(path("dangling.exr"), "after")) << m_failure.why;
    EXPECT_EQ(text_in(path("later.exr")), "after");

    const mode_t mask = umask(027);
    EXPECT_TRUE(write(path("new.exr"), "new"));
    umask(mask);
    EXPECT_EQ(fs::status(path("new.exr")).permissions(), fs::perms(0640));
}

TEST_F(WholeFiles, KeepAGroupThatMayBeGivenAndNoRightsOfOneThatMayNot) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can make another's files";
    constexpr uid_t other = 1234, me = 4321;
    constexpr gid_t shared = 7777, mine = 8888;
    fs::permissions(path("."), fs::perms::all);
    fs::permissions(temporary(""), fs::perms(0711));
    for (const bool member : {true, false}) {
        put(path("out.exr"), "before");
        ASSERT_EQ(chown(path("out.exr").c_str(), other, shared), 0);
        ASSERT_EQ(chmod(path("out.exr").c_str(), 04676), 0);
        const auto work = [&] {
            const std::vector<gid_t> groups(member ? 1 : 0, shared);
            return test::become(me, mine, groups) && write(path("out.exr"), "after") ? 0 : 1;
        };
        ASSERT_EQ(test::in_child(work).code, 0);
        struct stat there {};
        ASSERT_EQ(stat(path("out.exr").c_str(), &there), 0);
        EXPECT_EQ(there.st_uid, me);
        EXPECT_EQ(there.st_gid, member ? shared : mine);
        EXPECT_EQ(there.st_mode & 07777, member ? 0676u : 0666u);
        fs::remove(path("out.exr"));
    }
}

TEST_F(WholeFiles, AFullDiskIsAFailureThatMayPass) {
    put(path("out.exr"), "before");
    std::signal(SIGXFSZ, SIG_IGN);
    bool opened = false, committed = true;
    {
        WholeFile file;
        opened = file.open(path("out.exr"), m_failure);
        const test::ResourceLimit small(RLIMIT_FSIZE, 4096);
        // The writer does not look: what comes after fits again.
        for (int i = 0; i < 10000; ++i)
            std::fputs("text", file.file());
        std::fseek(file.file(), 0, SEEK_SET);
        std::fputs("head", file.file());
        committed = file.commit(m_failure);
    }
    EXPECT_TRUE(opened);
    EXPECT_FALSE(committed);
    EXPECT_EQ(m_failure.code, exit_resources);
    EXPECT_NE(m_failure.why.find("out.exr"), std::string::npos) << m_failure.why;
    EXPECT_EQ(text_in(path("out.exr")), "before");
    EXPECT_EQ(files(), 1u);
}

TEST_F(WholeFiles, WhatIsNotAllowedIsNamed) {
    EXPECT_FALSE(write(path("no/folder.exr"), "text"));
    EXPECT_EQ(m_failure.code, exit_failed);
    EXPECT_NE(m_failure.why.find("no/folder.exr"), std::string::npos) << m_failure.why;
    EXPECT_FALSE(write(path(""), "text"));
    EXPECT_NE(m_failure.why.find("directory"), std::string::npos) << m_failure.why;
    EXPECT_FALSE(write(path(std::string(300, 'x') + ".exr"), "text"));
    ASSERT_TRUE(write(path(std::string(251, 'x') + ".exr"), "text")) << m_failure.why;
}

/// Run `body` as a user who is not root and owns nothing, if this is root; in a child, which cannot
/// come back.
template <class Body>
bool holds_for_another(Body&& body) {
    constexpr uid_t me = 4321;
    const auto work = [&] { return (geteuid() != 0 || test::become(me, me)) && body() ? 0 : 1; };
    return test::in_child(work).code == 0;
}

TEST_F(WholeFiles, AFolderThatMayNotBeWrittenIsNamed) {
    const std::string folder = path("ro"), out = path("ro/out.exr");
    fs::permissions(path("."), fs::perms::all);
    fs::permissions(temporary(""), fs::perms(0711));
    fs::create_directory(folder);
    put(out, "before");
    fs::permissions(out, fs::perms(0666));
    fs::permissions(folder, fs::perms(0555));
    EXPECT_TRUE(holds_for_another([&] {
        const bool refused = !write(out, "after");
        EXPECT_EQ(m_failure.why, "cannot write \"" + out + "\": its folder \"" + folder +
                                     "\" cannot be written: Permission denied");
        return refused && !HasFailure();
    }));
    fs::permissions(folder, fs::perms::all);
}

TEST_F(WholeFiles, AnothersInAStickyFolderIsRefusedBeforeTheWork) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can make another's files";
    const std::string folder = path("scratch"), out = path("scratch/out.exr");
    fs::permissions(path("."), fs::perms::all);
    fs::permissions(temporary(""), fs::perms(0711));
    fs::create_directory(folder);
    ASSERT_EQ(chmod(folder.c_str(), 01777), 0);
    put(out, "before");
    ASSERT_EQ(chmod(out.c_str(), 0666), 0);
    const auto opened = [&] { return WholeFile().open(out, m_failure); };
    EXPECT_TRUE(opened()) << m_failure.why; // as root
    EXPECT_TRUE(holds_for_another([&] {
        const bool refused = !opened();
        EXPECT_NE(m_failure.why.find("folder \"" + folder + "\" is sticky"), std::string::npos)
            << m_failure.why;
        EXPECT_EQ(m_failure.code, exit_failed);
        return refused && !HasFailure();
    }));
    // Its owner's, the folder's owner's, and where it is not sticky.
    for (const auto& [file_owner, folder_owner, mode] :
         {std::tuple(4321u, 0u, 01777u), {0u, 4321u, 01777u}, {0u, 0u, 0777u}}) {
        ASSERT_EQ(chmod(folder.c_str(), 0700), 0); // or root may not write another's, either
        put(out, "before");
        ASSERT_EQ(chown(out.c_str(), file_owner, 0), 0);
        ASSERT_EQ(chown(folder.c_str(), folder_owner, 0), 0);
        ASSERT_EQ(chmod(folder.c_str(), mode), 0);
        EXPECT_TRUE(holds_for_another([&] { return write(out, "after"); }))
            << file_owner << " " << folder_owner;
        EXPECT_EQ(text_in(out), "after");
    }
}

TEST_F(WholeFiles, WhatIsNoFileIsWrittenDirectly) {
    EXPECT_TRUE(write("/dev/null", "text")) << m_failure.why;
    EXPECT_FALSE(write("/dev/full", "text"));
    EXPECT_EQ(m_failure.code, exit_resources);
    struct stat there {};
    ASSERT_EQ(stat("/dev/null", &there), 0);
    EXPECT_TRUE(S_ISCHR(there.st_mode));
}

TEST_F(WholeFiles, ALinkToAPipeIsThePipe) {
    int ends[2] = {};
    ASSERT_EQ(pipe(ends), 0);
    fs::create_symlink("/proc/self/fd/" + std::to_string(ends[1]), path("link.png"));
    EXPECT_TRUE(write(path("link.png"), "text")) << m_failure.why;
    char text[5] = {};
    EXPECT_EQ(read(ends[0], text, 4), 4);
    EXPECT_STREQ(text, "text");
    EXPECT_EQ(files(), 1u);
    close(ends[0]);
    close(ends[1]);
}

} // namespace
} // namespace ddt::tool
