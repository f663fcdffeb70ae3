// SPDX-License-Identifier: Apache-2.0
// Commands run within the tests' own process.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plugin/tool/command/command.h"

namespace ddt::tool {

/// What a command said, on stdout and on stderr, and how it ended.
struct Ran {
    ExitCode code;
    std::string out, err;
};

inline Ran run(std::unique_ptr<Command> command, const std::vector<std::string>& args) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const ExitCode code = parse_and_run(*command, args);
    std::fflush(stdout);
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

} // namespace ddt::tool
