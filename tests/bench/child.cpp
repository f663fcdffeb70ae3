// SPDX-License-Identifier: Apache-2.0
#include "child.h"

#include <cstdlib>
#include <filesystem>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bench {

int run_child(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    pid_t pid;
    if (posix_spawnp(&pid, argv[0], nullptr, nullptr, argv.data(), environ) != 0)
        return 127;
    int status;
    if (waitpid(pid, &status, 0) != pid)
        return 127;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

ScratchFolder::ScratchFolder() {
    std::error_code error;
    std::string path = (std::filesystem::temp_directory_path(error) / "ddt-bench-XXXXXX").string();
    if (!error && mkdtemp(path.data()))
        m_path = path;
}

ScratchFolder::~ScratchFolder() {
    std::error_code error;
    if (!m_path.empty())
        std::filesystem::remove_all(m_path, error);
}

std::string ScratchFolder::file(const std::string& name) const {
    return m_path.empty() ? std::string() : m_path + "/" + name;
}

} // namespace bench
