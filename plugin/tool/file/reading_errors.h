// SPDX-License-Identifier: Apache-2.0
// Why a file could not be read, of which its reader may say something else.
#pragma once

#include <string>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// If a file cannot be opened, or its bytes cannot be read, readers call it broken or none of their
/// format: the code for the reason then, else `otherwise`. Reads the bytes, so it is to be called
/// after a failure only.
ExitCode code_of_reading(const std::string& path, ExitCode otherwise = exit_failed);

/// If a file is there and cannot be opened, readers say that it is none of theirs: what the system
/// says then, such as "Permission denied". Empty for a file that can be opened, and for a name of
/// no file, which readers may know what to make of.
std::string why_not_opened(const std::string& path);

} // namespace ddt::tool
