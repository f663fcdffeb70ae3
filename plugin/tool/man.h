// SPDX-License-Identifier: Apache-2.0
// What ddt says of itself, made of what its commands say of themselves.
#pragma once

#include <string>

#include "plugin/tool/commands.h"

namespace ddt::tool {

/// The manual page ddt(1) in man(7)'s macros.
std::string man_page(const std::vector<std::unique_ptr<Command>>& commands);

/// What `ddt --help` prints.
std::string overview(const std::vector<std::unique_ptr<Command>>& commands);

} // namespace ddt::tool
