// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/commands.h"

namespace ddt::tool {

std::vector<std::unique_ptr<Command>> make_commands() {
    std::vector<std::unique_ptr<Command>> commands;
    commands.push_back(make_resize_command());
    commands.push_back(make_join_command());
    commands.push_back(make_stream_command());
    commands.push_back(make_mesh_command());
    commands.push_back(make_scatter_command());
    commands.push_back(make_fill_command());
    commands.push_back(make_compare_command());
    commands.push_back(make_info_command());
    return commands;
}

} // namespace ddt::tool
