// SPDX-License-Identifier: Apache-2.0
// How many threads a command works with.
#pragma once

#include "plugin/tool/command/command.h"

namespace ddt::tool {

/// --threads, whose value is how many are wanted.
Flag threads_flag(int& wanted);

/// The threads that a command works with where `wanted` are asked for; 0: as many as OpenImageIO's
/// attribute "threads" says, which is all, or what a container's quota is worth. So many may be at
/// work from then on, be it more than there are cores.
int planned_threads(int wanted);

/// The same, to work with. OpenImageIO gets as many to read and write with, those that OpenEXR
/// decompresses with among them.
int share_threads(int wanted);

} // namespace ddt::tool
