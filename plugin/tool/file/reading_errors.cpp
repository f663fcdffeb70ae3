// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/reading_errors.h"

#include <cerrno>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ddt::tool {

namespace {

/// A descriptor, or less than 0 with errno. Of a pipe at once: nobody may be at its other end.
int open_to_read(const std::string& path) {
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

} // namespace

ExitCode code_of_reading(const std::string& path, ExitCode otherwise) {
    const int descriptor = open_to_read(path);
    if (descriptor < 0)
        return code_of_errno(errno);
    std::vector<char> bytes(size_t(1) << 20);
    ExitCode code = otherwise;
    struct stat there {};
    if (fstat(descriptor, &there) != 0)
        code = code_of_errno(errno);
    else if (S_ISREG(there.st_mode)) {
        ssize_t n = 1;
        while (n > 0)
            n = ::read(descriptor, bytes.data(), bytes.size());
        code = n < 0 ? code_of_errno(errno) : otherwise;
    }
    ::close(descriptor);
    return code;
}

std::string why_not_opened(const std::string& path) {
    const int descriptor = open_to_read(path);
    if (descriptor < 0)
        return errno == ENOENT ? "" : std::strerror(errno);
    ::close(descriptor);
    return {};
}

} // namespace ddt::tool
