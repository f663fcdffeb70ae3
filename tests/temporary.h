// SPDX-License-Identifier: Apache-2.0
// A place for a test's files. Tests run side by side, several of them of one program, so a fixed
// name in /tmp would be one test's output and another's input.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace ddt {

/// The path of `name` in a folder of this process alone, which goes when the process ends.
inline std::string temporary(const std::string& name) {
    struct Folder {
        Folder() : owner(getpid()) {
            path = (std::filesystem::temp_directory_path() / "ddt-test-XXXXXX").string();
            if (!mkdtemp(path.data()))
                throw std::runtime_error("cannot make the folder " + path);
        }
        ~Folder() {
            std::error_code ignored;
            if (getpid() == owner) // not a forked child's to remove
                std::filesystem::remove_all(path, ignored);
        }
        std::string path;
        pid_t owner;
    };
    static const Folder folder;
    return folder.path + "/" + name;
}

/// The whole of a file, or nothing.
inline std::string text_in(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace ddt
