// SPDX-License-Identifier: Apache-2.0
// All commands.
#pragma once

#include <memory>
#include <vector>

#include "plugin/tool/command/command.h"

namespace ddt::tool {

std::unique_ptr<Command> make_resize_command();
std::unique_ptr<Command> make_join_command();
std::unique_ptr<Command> make_stream_command();
std::unique_ptr<Command> make_mesh_command();
std::unique_ptr<Command> make_scatter_command();
std::unique_ptr<Command> make_fill_command();
std::unique_ptr<Command> make_compare_command();
std::unique_ptr<Command> make_info_command();

/// In the order in which help lists them.
std::vector<std::unique_ptr<Command>> make_commands();

} // namespace ddt::tool
