// SPDX-License-Identifier: Apache-2.0
// What a command line with a sequence stands for.
#pragma once

#include <string>
#include <vector>

#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/sequence/run_frames.h"

namespace ddt::tool {

/// Whether names are those of sequences: frames or views are given, or `in` has a place for a
/// frame's number and is no file's name as it stands. (In a folder's name, too, where list_tasks()
/// tells that there is none.)
bool is_sequence(const std::string& in, const std::string& frames, const std::string& views);

/// The files of the frames and views, frame by frame. `frames` empty: those of which there is a
/// file; a failure where the folder of one cannot be listed. `views`: names after commas, blanks
/// about them left out, or empty.
bool list_tasks(const std::string& in, const std::string& out, const std::string& frames,
                const std::string& views, std::vector<FrameTask>& tasks, Failure& failure);

} // namespace ddt::tool
