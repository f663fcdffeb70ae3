// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/file_state.h"

#include <filesystem>
#include <fstream>

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "tests/temporary.h"

namespace ddt::tool {
namespace {

namespace fs = std::filesystem;

class FileStates : public testing::Test {
protected:
    FileStates() { std::ofstream(m_path) << "before"; }

    const std::string m_path = temporary("state");
};

TEST_F(FileStates, ReadingChangesNothing) {
    const FileState state(m_path);
    EXPECT_EQ(text_in(m_path), "before");
    EXPECT_TRUE(state.is_unchanged());
}

TEST_F(FileStates, OtherBytesAreAChangeEvenOfTheSameSizeAndTime) {
    const FileState state(m_path);
    const auto time = fs::last_write_time(m_path);
    std::ofstream(m_path) << "after!";
    fs::last_write_time(m_path, time);
    EXPECT_FALSE(state.is_unchanged());
}

TEST_F(FileStates, LinksAndRightsAreNoChange) {
    const FileState state(m_path);
    const std::string link = temporary("state's link");
    fs::create_hard_link(m_path, link);
    EXPECT_TRUE(state.is_unchanged());
    const FileState linked(m_path);
    fs::remove(link);
    EXPECT_TRUE(linked.is_unchanged());
    fs::permissions(m_path, fs::perms::owner_read, fs::perm_options::remove);
    EXPECT_TRUE(linked.is_unchanged());
}

TEST_F(FileStates, AFileThatGoesOnceItWasReadIsOne) {
    const FileState state(m_path);
    fs::remove(m_path);
    EXPECT_TRUE(state.is_of_one_file(true));
    EXPECT_FALSE(state.is_of_one_file(false));
    std::ofstream(m_path) << "another";
    EXPECT_FALSE(state.is_of_one_file(true));
}

TEST_F(FileStates, AnotherFileOfTheNameIsAChange) {
    const FileState state(m_path);
    const std::string other = temporary("other state");
    std::ofstream(other) << "before";
    fs::rename(other, m_path);
    EXPECT_FALSE(state.is_unchanged());
}

TEST_F(FileStates, ThatAFileGoesOrComesIsAChange) {
    const FileState there(m_path);
    fs::remove(m_path);
    EXPECT_FALSE(there.is_unchanged());
    const FileState missing(m_path);
    EXPECT_TRUE(missing.is_unchanged());
    std::ofstream(m_path) << "before";
    EXPECT_FALSE(missing.is_unchanged());
}

TEST_F(FileStates, OfWhatIsNoFileNothingIsKnown) {
    const std::string pipe = temporary("state pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const std::string& name : {pipe, m_path + ".ddt?scale=2", std::string()}) {
        const FileState state(name);
        if (name == pipe)
            std::fstream(pipe) << "passes through";
        EXPECT_TRUE(state.is_unchanged()) << name;
    }
}

TEST_F(FileStates, AChangeIsTheReasonOfWhatWasMadeOrWasNot) {
    struct Case {
        bool made;
        ExitCode before, after;
    };
    for (const bool changed : {false, true})
        for (const Case& c :
             {Case{true, exit_failed, exit_resources}, Case{false, exit_failed, exit_resources},
              Case{false, exit_usage, exit_usage}, Case{false, exit_resources, exit_resources}}) {
            const FileState state(m_path);
            if (changed)
                std::ofstream(m_path, std::ios::app) << "more";
            Failure failure{"said before", c.before};
            EXPECT_EQ(state.confirm(c.made, failure), c.made && !changed);
            EXPECT_EQ(failure.code, changed ? c.after : c.before);
            const bool told = changed && c.before == exit_failed;
            EXPECT_EQ(failure.why,
                      told ? "\"" + m_path + "\" was changed while it was read" : "said before");
        }
}

} // namespace
} // namespace ddt::tool
